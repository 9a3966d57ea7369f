#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/text.h"

#include "experiments/common/map_view/html.h"
#include "experiments/common/records.h"
#include "experiments/experiment_report/page.h"

namespace cirque::experiment_report {
namespace {

const std::vector<std::pair<std::string, std::string>> kProvenance = {
    {"config", "/provenance/config"},
    {"config hash", "/provenance/config_hash"},
    {"version", "/provenance/version"},
    {"commit", "/provenance/commit"},
    {"build", "/provenance/build"},
    {"compiler", "/provenance/compiler"},
    {"cpu", "/provenance/cpu"},
    {"cores", "/provenance/cores"},
    {"host", "/provenance/host"},
    {"BLAS threads", "/provenance/blas_threads"},
    {"libraries", "/provenance/libraries"}};

/// The different values at a place of the records, "a" or "a; b".
std::string Distinct(const std::vector<Run>& runs, const std::string& pointer) {
  std::set<std::string> values;
  for (const Run& run : runs) values.insert(TextAt(run.record, pointer));
  values.erase("");
  return Join({values.begin(), values.end()}, "; ");
}

std::string WithoutQuotes(const std::string& json) {
  std::string text;
  for (const char c : json) {
    if (c == ',')
      text += ", ";
    else if (c == ':')
      text += " ";
    else if (c != '"' && c != '{' && c != '}')
      text += c;
  }
  return text;
}

std::string ProvenanceRow(const std::string& name, const std::string& value) {
  if (value.empty()) return "";
  return fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", name, Escape(value));
}

std::string ProvenanceHtml(const std::vector<Run>& runs) {
  std::string rows;
  for (const auto& [name, pointer] : kProvenance) {
    const std::string value = Distinct(runs, pointer);
    rows += ProvenanceRow(name, value.starts_with('{') ? WithoutQuotes(value) : value);
  }
  std::set<std::string> started;
  for (const Run& run : runs) started.insert(TextAt(run.record, "/provenance/started"));
  started.erase("");
  if (!started.empty()) {
    rows += ProvenanceRow("runs started", *started.begin() + " to " + *started.rbegin());
  }
  return "<details><summary>What it was run with</summary><table class=\"facts\">" + rows +
         "</table></details>\n";
}

std::string Tile(const std::string& css, int number, const std::string& what) {
  return fmt::format("<div class=\"tile {}\"><b>{}</b>{}</div>", number > 0 ? css : "none", number,
                     what);
}

/// What an outcome without a map says.
struct FailureKind {
  std::string heading, meaning;
  std::set<std::string> outcomes;
};

/// The last is of every outcome that no other names.
const std::vector<FailureKind>& FailureKinds() {
  static const std::vector<FailureKind> kKinds = {
      {"Expected: there is no map, and it is said why",
       "The surface has none of this kind, by a proof, or was not to be mapped; or the strategy "
       "has "
       "no such form of the energy.",
       {"infeasible", "invalid_input", "unsupported"}},
      {"Limits that were met",
       "Of iterations, floating point, time or memory: more of them may help.",
       {"not_converged", "unrepresentable", "inaccurate", "time_limit", "memory_limit",
        "cancelled"}},
      {"Faults", "A program failed, or made what is no map.", {}}};
  return kKinds;
}

const FailureKind& KindOf(const std::string& outcome) {
  const std::vector<FailureKind>& kinds = FailureKinds();
  for (const FailureKind& kind : kinds) {
    if (kind.outcomes.contains(outcome)) return kind;
  }
  return kinds.back();
}

using RunsByOutcome = std::map<std::string, std::vector<const Run*>>;

std::string OutcomesHtml(const RunsByOutcome& by_outcome) {
  std::string html;
  for (const auto& [outcome, members] : by_outcome) {
    html += fmt::format("<details open><summary>{}: {}</summary><table class=\"facts failures\">",
                        Escape(outcome), members.size());
    for (const Run* run : members) {
      html += fmt::format(
          "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"message\">{}</td></tr>\n",
          Escape(run->mesh), Escape(run->method), Escape(run->message));
    }
    html += "</table></details>\n";
  }
  return html;
}

}  // namespace

Verdicts CountVerdicts(const std::vector<Run>& runs) {
  Verdicts verdicts;
  for (const Run& run : runs) {
    ++(run.IsOk()                    ? verdicts.ok
       : run.outcome == "infeasible" ? verdicts.infeasible
                                     : verdicts.failed);
  }
  return verdicts;
}

std::string SummaryHtml(const Results& results, const std::vector<Comparison>& comparisons) {
  const Verdicts verdicts = CountVerdicts(results.runs);
  const std::string question = Distinct(results.runs, "/provenance/question");
  std::string html;
  if (!question.empty()) html += "<p class=\"question\">" + Escape(question) + "</p>\n";
  for (const std::string& sentence : VerdictsOf(comparisons)) {
    html += "<p class=\"answer\">" + Escape(sentence) + "</p>\n";
  }
  html += "<div class=\"tiles\">" + Tile("all", static_cast<int>(results.runs.size()), "runs") +
          Tile("ok", verdicts.ok, "maps") + Tile("infeasible", verdicts.infeasible, "infeasible") +
          Tile("failed", verdicts.failed, "failed") + "</div>\n";
  if (results.superseded > 0) {
    html += fmt::format(
        "<p class=\"note\">Older records of the same runs, by other code, are left "
        "out: {}.</p>\n",
        results.superseded);
  }
  if (results.skipped_lines > 0) {
    html += fmt::format(
        "<p class=\"note\">{} unreadable {} passed over: the run is under way, or "
        "was interrupted while it wrote.</p>\n",
        results.skipped_lines, results.skipped_lines == 1 ? "line was" : "lines were");
  }
  return html + ProvenanceHtml(results.runs);
}

std::string FailuresHtml(const std::vector<Run>& runs) {
  std::map<std::string, RunsByOutcome> by_kind;
  for (const Run& run : runs) {
    if (!run.IsOk()) by_kind[KindOf(run.outcome).heading][run.outcome].push_back(&run);
  }
  std::string html;
  for (const FailureKind& kind : FailureKinds()) {
    if (!by_kind.contains(kind.heading)) continue;
    html += "<h3>" + Escape(kind.heading) + "</h3>\n<p class=\"note\">" + Escape(kind.meaning) +
            "</p>\n" + OutcomesHtml(by_kind[kind.heading]);
  }
  return html;
}

}  // namespace cirque::experiment_report

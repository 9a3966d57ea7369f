#include "cirque/audit/audit_energy.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace cirque {

void AuditFinding::Note(double new_figure, const std::string& new_where) {
  const bool is_worse = where.empty() || !(new_figure <= figure);
  if (!is_worse || std::isnan(figure)) return;
  figure = new_figure;
  where = new_where;
}

std::vector<AuditFinding> AuditEnergy(const std::vector<AuditCase>& cases,
                                      const std::vector<AuditCheck>& checks) {
  std::vector<AuditFinding> findings;
  for (const AuditCheck& check : checks) {
    AuditFinding finding;
    finding.check = check.name;
    finding.bound = check.bound;
    for (const AuditCase& c : cases) check.run(c, &finding);
    findings.push_back(finding);
  }
  return findings;
}

namespace {

constexpr int kColumn = 11;

std::string Entry(const AuditFinding& finding) {
  if (!finding.applies) return "-";
  return finding.ok() ? "ok" : fmt::format("{:.2g}", finding.figure);
}

std::string Failures(const AuditRow& row) {
  if (!row.status.ok()) return fmt::format("{}: {}\n", row.energy, row.status.message());
  std::string text;
  for (const AuditFinding& f : row.findings) {
    if (f.ok()) continue;
    text += fmt::format("{}: {} failed: {:.3g} > {:g} at {}\n", row.energy, f.check, f.figure,
                        f.bound, f.where);
  }
  return text;
}

/// The heads of the columns: of the first row that has findings.
std::vector<std::string> CheckNames(const std::vector<AuditRow>& rows) {
  std::vector<std::string> names;
  for (const AuditRow& row : rows) {
    if (row.findings.empty()) continue;
    for (const AuditFinding& f : row.findings) names.push_back(f.check);
    break;
  }
  return names;
}

}  // namespace

bool AuditRow::ok() const {
  return status.ok() && !findings.empty() &&
         std::all_of(findings.begin(), findings.end(),
                     [](const AuditFinding& f) { return f.ok(); });
}

bool AllOk(const std::vector<AuditRow>& rows) {
  return !rows.empty() &&
         std::all_of(rows.begin(), rows.end(), [](const AuditRow& row) { return row.ok(); });
}

std::string ToText(const std::vector<AuditRow>& rows) {
  std::size_t width = 6;
  for (const AuditRow& row : rows) width = std::max(width, row.energy.size());
  std::string text = fmt::format("{:<{}}", "energy", width);
  for (const std::string& check : CheckNames(rows)) text += fmt::format("{:>{}}", check, kColumn);
  text += "\n";
  for (const AuditRow& row : rows) {
    text += fmt::format("{:<{}}", row.energy, width);
    for (const AuditFinding& f : row.findings) text += fmt::format("{:>{}}", Entry(f), kColumn);
    text += row.status.ok() ? "\n" : "  not audited\n";
  }
  for (const AuditRow& row : rows) text += Failures(row);
  return text;
}

std::string ToJson(const std::vector<AuditRow>& rows) {
  nlohmann::ordered_json json;
  json["ok"] = AllOk(rows);
  json["energies"] = nlohmann::ordered_json::array();
  for (const AuditRow& row : rows) {
    nlohmann::ordered_json energy = {{"energy", row.energy}, {"ok", row.ok()}};
    if (!row.status.ok()) energy["error"] = row.status.message();
    energy["checks"] = nlohmann::ordered_json::array();
    for (const AuditFinding& f : row.findings) {
      energy["checks"].push_back({{"check", f.check},
                                  {"applies", f.applies},
                                  {"ok", f.ok()},
                                  {"figure", f.figure},
                                  {"bound", f.bound},
                                  {"where", f.where}});
    }
    json["energies"].push_back(energy);
  }
  return json.dump(2) + "\n";
}

}  // namespace cirque

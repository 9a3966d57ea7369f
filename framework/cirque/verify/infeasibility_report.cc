#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cirque/core/text.h"
#include "cirque/verify/infeasibility_check.h"
#include "cirque/verify/report_words.h"

namespace cirque::verify {
namespace {

/// "vertex 5: 100 pi, vertex 7: 1.5 to 2 pi and 3 more".
std::string OwnTargets(const InfeasibilityReport& report) {
  constexpr std::size_t kShown = 8;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < report.own_targets.size() && i < kShown; ++i) {
    const auto& [lower, upper] = report.own_intervals[i];
    words.push_back(
        lower == upper
            ? fmt::format("vertex {}: {:.9g} pi", report.own_targets[i], lower)
            : fmt::format("vertex {}: {:.9g} to {:.9g} pi", report.own_targets[i], lower, upper));
  }
  if (report.own_targets.size() > kShown) {
    words.push_back(fmt::format("and {} more", report.own_targets.size() - kShown));
  }
  return Join(words);
}

/// What the claim is about comes before whether it holds.
std::string TargetLine(const InfeasibilityReport& report) {
  const std::string asked = report.targets_given
                                ? "those of the file given"
                                : "2 pi at inner vertices, boundary free (the default's)";
  if (report.own_targets.empty()) return Line("targets", asked);
  if (report.proves_asked) {
    return Line("targets", fmt::format("{}; the certificate names others ({}), but holds for these",
                                       asked, OwnTargets(report)));
  }
  return Line("targets", fmt::format("the certificate's own ({}), not {}", OwnTargets(report),
                                     report.targets_given ? asked : "the default's"));
}

std::string InequalityLines(const InfeasibilityReport& report) {
  std::string text =
      Line("constraints", fmt::format("2 pi at {}", Count(report.num_flat, "inner vertex")));
  if (!report.cones.empty()) {
    text += Line(
        "", fmt::format("other than 2 pi at {} ({})", Count(report.cones.size(), "inner vertex"),
                        IdList(report.cones, static_cast<int>(report.cones.size()))));
  }
  if (!report.prescribed.empty()) {
    text += Line(
        "", fmt::format("prescribed at {} ({})", Count(report.prescribed.size(), "boundary vertex"),
                        IdList(report.prescribed)));
  }
  return text +
         Line("inequality", fmt::format("left {:.17g}, right {:.17g}, difference {:.6g} (exact)",
                                        report.left, report.right, report.margin));
}

}  // namespace

std::string InfeasibilityReport::Verdict() const {
  if (!accepted()) return "REJECTED: " + Join(errors, "; ");
  std::string claim = "no coherent angles";
  if (removed_vertex != kNone) {
    claim += fmt::format(
        " {}without vertex {}, margin eps = {:.6g} pi, its neighbours at most {:.9g} pi",
        straight_boundary ? "with a straight boundary " : "", removed_vertex, epsilon_over_pi,
        link_upper_over_pi);
  } else if (epsilon_over_pi > 0) {
    claim += fmt::format(" with margin eps = {:.6g} pi", epsilon_over_pi);
  }
  if (proves_asked) return fmt::format("accepted ({})", claim);
  return fmt::format(
      "NOT PROVEN of the targets asked about: {} for targets that the certificate names itself "
      "({})",
      claim, OwnTargets(*this));
}

std::string ToText(const InfeasibilityReport& report) {
  std::string text = report.evaluated ? TargetLine(report) : "";
  text += Line("triangles",
               fmt::format("{}{}", report.num_triangles,
                           report.names_triangles ? ", as the certificate names them" : ""));
  if (report.num_faces_left_out > 0) {
    text += Line("", fmt::format("not about {} of the file",
                                 Count(report.num_faces_left_out, "other face")));
  }
  text +=
      Line("margin eps",
           fmt::format("{:.6g} pi{}", report.epsilon_over_pi,
                       report.epsilon_over_pi > 0 ? " (proves nothing for smaller margins)" : ""));
  if (report.removed_vertex != kNone) {
    text += Line("removed vertex", fmt::format("{}, its neighbours limited to {:.17g} pi",
                                               report.removed_vertex, report.link_upper_over_pi));
  }
  if (report.num_beyond_chords > 0) {
    text += Line("left out", fmt::format("{} beyond edges between boundary vertices",
                                         Count(report.num_beyond_chords, "triangle")));
  }
  if (report.evaluated) text += InequalityLines(report);
  return text + "verdict: " + report.Verdict() + "\n";
}

std::string ToJson(const InfeasibilityReport& report) {
  nlohmann::ordered_json json;
  json["accepted"] = report.accepted() && report.proves_asked;
  json["holds_for_own_targets"] = report.accepted();
  json["targets"] = report.targets_given ? "given" : "default";
  json["vertices_with_own_targets"] = report.own_targets;
  json["verdict"] = report.Verdict();
  json["errors"] = report.errors;
  json["triangles"] = report.num_triangles;
  json["faces_left_out"] = report.num_faces_left_out;
  json["epsilon_over_pi"] = report.epsilon_over_pi;
  if (report.removed_vertex != kNone) {
    json["removed_vertex"] = report.removed_vertex;
    json["link_upper_over_pi"] = report.link_upper_over_pi;
    json["straight_boundary"] = report.straight_boundary;
    json["triangles_beyond_chords"] = report.num_beyond_chords;
  }
  if (report.evaluated) {
    json["left"] = report.left;
    json["right"] = report.right;
    json["margin"] = report.margin;
  }
  json["flat_vertices"] = report.num_flat;
  json["cones"] = report.cones;
  json["prescribed_boundary_vertices"] = report.prescribed;
  return FiniteJson(std::move(json));
}

}  // namespace cirque::verify

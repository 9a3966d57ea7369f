#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cirque/core/text.h"
#include "cirque/verify/findings.h"
#include "cirque/verify/infeasibility_check.h"

namespace cirque::verify {
namespace {

std::string Line(const std::string& name, const std::string& text) {
  return fmt::format("{:<18}{}\n", name, text);
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
  if (removed_vertex != kNone) {
    return fmt::format(
        "accepted (no coherent angles {}without vertex {}, margin eps = {:.6g} pi, its neighbours "
        "at "
        "most {:.9g} pi)",
        straight_boundary ? "with a straight boundary " : "", removed_vertex, epsilon_over_pi,
        link_upper_over_pi);
  }
  if (epsilon_over_pi == 0) return "accepted (no coherent angles)";
  return fmt::format("accepted (no coherent angles with margin eps = {:.6g} pi)", epsilon_over_pi);
}

std::string ToText(const InfeasibilityReport& report) {
  std::string text = Line("triangles", fmt::format("{}", report.num_triangles));
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
  json["accepted"] = report.accepted();
  json["verdict"] = report.Verdict();
  json["errors"] = report.errors;
  json["triangles"] = report.num_triangles;
  json["epsilon_over_pi"] = report.epsilon_over_pi;
  if (report.removed_vertex != kNone) {
    json["removed_vertex"] = report.removed_vertex;
    json["link_upper_over_pi"] = report.link_upper_over_pi;
    json["straight_boundary"] = report.straight_boundary;
    json["triangles_beyond_chords"] = report.num_beyond_chords;
  }
  const auto known = [&](double x) { return report.evaluated ? nlohmann::json(x) : nullptr; };
  json["left"] = known(report.left);
  json["right"] = known(report.right);
  json["margin"] = known(report.margin);
  json["flat_vertices"] = report.num_flat;
  json["cones"] = report.cones;
  json["prescribed_boundary_vertices"] = report.prescribed;
  return json.dump(2) + "\n";
}

}  // namespace cirque::verify

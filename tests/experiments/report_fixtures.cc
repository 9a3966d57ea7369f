#include "tests/experiments/report_fixtures.h"

#include <cmath>

#include <fmt/format.h>
#include <glog/logging.h>

namespace cirque {

nlohmann::json ReportRecord(const std::string& mesh, const std::string& method, double seconds) {
  return {
      {"key", mesh + "-" + method},
      {"mesh", {{"name", mesh}, {"hash", "h-" + mesh}, {"vertices", 60}, {"triangles", 100}}},
      {"method", {{"name", method}, {"radii_solver", "newton"}, {"angle_solver", "newton"}}},
      {"repeat", 0},
      {"outcome", "ok"},
      {"message", ""},
      {"overlap", "injective"},
      {"values",
       {{"quasi_conformal_mean", 1.25}, {"quasi_conformal_max", 3.5}, {"log_area_ratio_l2", 0.5}}},
      {"seconds", {{"total", seconds}}},
      {"history", {{"radii", {10.0, 1.0, 1e-9}}, {"angles", {1.0, 1e-8}}}},
      {"provenance", {{"started", "2026-01-01T00:00:00Z"}, {"question", "Which is faster?"}}}};
}

std::string JsonLines(const std::vector<nlohmann::json>& records) {
  std::string lines;
  for (const nlohmann::json& record : records) lines += record.dump() + "\n";
  return lines;
}

experiment_report::Results ResultsOf(const std::vector<nlohmann::json>& records) {
  const TemporaryFolder folder;
  folder.Write("results.jsonl", JsonLines(records));
  auto results = experiment_report::ReadResults(folder.path());
  CHECK(results.ok()) << results.status().message();
  return *std::move(results);
}

std::string PyramidObj(double apex_angle) {
  // Edges of length 1 at the apex, which four triangles share; the base's chord follows.
  const double chord = 2 * std::sin(apex_angle / 8), radius = chord / std::sqrt(2.0);
  std::string obj = fmt::format("v 0 0 {}\n", std::sqrt(1 - radius * radius));
  for (int i = 0; i < 4; ++i) {
    const double angle = i * std::acos(-1.0) / 2;
    obj += fmt::format("v {} {} 0\n", radius * std::cos(angle), radius * std::sin(angle));
  }
  obj += "vt 0 0\n";
  for (int i = 0; i <= 4; ++i) {
    const double angle = i * apex_angle / 4;
    obj += fmt::format("vt {} {}\n", std::cos(angle), std::sin(angle));
  }
  for (int i = 0; i < 4; ++i) {
    obj += fmt::format("f 1/1 {}/{} {}/{}\n", i + 2, i + 2, (i + 1) % 4 + 2, i + 3);
  }
  return obj;
}

}  // namespace cirque

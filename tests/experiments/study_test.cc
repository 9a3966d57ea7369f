// experiments/scripts/make_study: the tables it makes of records, against records whose figures are known.
#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/common/paths.h"
#include "tests/common/run_program.h"
#include "tests/common/temporary_folder.h"
#include "tests/experiments/report_fixtures.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class StudyTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (RunShell("/usr/bin/python3 -c 'import matplotlib'").exit_status != 0) {
      GTEST_SKIP() << "matplotlib is not installed (Debian: apt-get install python3-matplotlib)";
    }
  }

  ProgramResult Study(const std::string& name) const {
    return RunShell(ProjectPath("experiments/scripts/make_study") + " " + name + " --records " +
                    folder_.path() + " --output " + folder_.Path("out.md"));
  }

  /// The page made of these records.
  std::string Page(const std::string& name, const std::vector<nlohmann::json>& records) {
    folder_.Write("results.jsonl", JsonLines(records));
    const ProgramResult made = Study(name);
    EXPECT_EQ(made.exit_status, 0) << made.output;
    EXPECT_THAT(folder_.Read("out.svg"), HasSubstr("<svg"));
    return folder_.Read("out.md");
  }

  TemporaryFolder folder_;
};

/// A run of `family` whose stages take 1e-6 n^1.25 s, beside a reference of 1e-6 n s, in n KiB.
nlohmann::json ScalingRecord(const std::string& family, double n) {
  nlohmann::json record = ReportRecord(family + "-" + std::to_string(n), "default", 0);
  record["mesh"]["family"] = family;
  record["mesh"]["triangles"] = n;
  const double seconds = 1e-6 * std::pow(n, 1.25);
  for (const char* stage : {"triangulation", "angles", "radii", "layout", "measures", "total"}) {
    record["seconds"][stage] = seconds;
  }
  record["map_cpu_seconds"] = 5 * seconds;
  record["reference"] = {{"seconds", 1e-6 * n}, {"cpu_seconds", 1e-6 * n}};
  record["peak_memory_mib"] = n / 1024;
  return record;
}

TEST_F(StudyTest, ScalingFindsTheExponentAndTheMultiplesOfR) {
  std::vector<nlohmann::json> records;
  for (const double n : {1e4, 1e5, 1e6}) records.push_back(ScalingRecord("terrain", n));
  nlohmann::json failed = ScalingRecord("car", 1e5);
  failed["outcome"] = "memory_limit";
  records.push_back(failed);
  const std::string page = Page("scaling", records);
  EXPECT_THAT(page,
              HasSubstr("| terrain | 10000.0 to 1000000.0 | - | - | 1.25 | 1.25 | 1.25 | 1.25 "
                        "| 1.25 | 1.25 | 1.25 | 1.00 | 1.00 |"));
  // n^0.25 = 10 at 1e4: every stage is 10 R, the five of them 50, and so is the CPU time.
  EXPECT_THAT(page,
              HasSubstr("| 10000.0 | 0.01 | 10.0 | 10.0 | 10.0 | 10.0 | 10.0 | 50.0 | 50.0 |"));
  EXPECT_THAT(page, HasSubstr("| 1024 |"));  // bytes a triangle
  EXPECT_THAT(page, HasSubstr("Without a map: car-100000.000000 (memory_limit)."));
}

nlohmann::json ObjectiveRecord(const std::string& mesh, const std::string& objective,
                               double distortion, double cpu) {
  nlohmann::json record = ReportRecord(mesh, "raw,angle_objective=" + objective, 1);
  record["method"]["angle_objective"] = objective;
  record["values"]["quasi_conformal_mean"] = 1 + distortion;
  record["values"]["angle_error_mean"] = distortion;
  record["cpu_seconds"] = cpu;
  return record;
}

TEST_F(StudyTest, TheVerdictComparesOnMeshesThatBothMap) {
  std::vector<nlohmann::json> records = {
      ObjectiveRecord("a", "quadratic", 0.1, 1), ObjectiveRecord("a", "barrier", 0.105, 3),
      ObjectiveRecord("b", "quadratic", 0.2, 1), ObjectiveRecord("b", "barrier", 0.3, 2),
      ObjectiveRecord("c", "quadratic", 0.1, 1), ObjectiveRecord("c", "barrier", 0.5, 9),
      ObjectiveRecord("d", "quadratic", 0.1, 1), ObjectiveRecord("d", "barrier", 9, 9)};
  records.back()["outcome"] = "infeasible";
  const std::string page = Page("qp_vs_nonlinear", records);
  EXPECT_THAT(page, HasSubstr("1.5 times the quadratic program's (median of 3 meshes; 1.05 to 5), "
                              "within 10 % on 1 and within a factor of 2 on 2 of them; it takes 3 "
                              "times the CPU time."));
  EXPECT_THAT(page, HasSubstr("3 ok, 1 infeasible"));
}

TEST_F(StudyTest, StrategiesAreComparedByStageAndGrowth) {
  std::vector<nlohmann::json> records;
  for (const double n : {1e3, 1e4, 1e5}) {
    nlohmann::json record =
        ReportRecord("bumpy_terrain-" + std::to_string(n), "radii,radii_solver=newton", 1);
    record["mesh"]["family"] = "bumpy_terrain";
    record["mesh"]["triangles"] = n;
    record["cpu_seconds"] = 1e-9 * n * n;
    record["values"] = {{"radii_iterations", 4}, {"radii_factorizations", 2}};
    records.push_back(record);
  }
  const std::string page = Page("strategies", records);
  EXPECT_THAT(page, HasSubstr("4 / 2 / 0.001 |"));
  EXPECT_THAT(page, HasSubstr("| exponent of the time |  | 2.00 |"));
}

TEST_F(StudyTest, DomainsAreComparedWithThePlaneOnTheSameMesh) {
  std::vector<nlohmann::json> records;
  for (const std::string domain : {"plane", "disk"}) {
    nlohmann::json record = ReportRecord("a", "m,domain=" + domain, 1);
    record["method"]["domain"] = domain;
    record["values"]["flipped_triangles"] = 0;
    record["values"]["quasi_conformal_mean"] = domain == "plane" ? 1.0 : 1.25;
    record["cpu_seconds"] = domain == "plane" ? 2 : 3;
    records.push_back(record);
  }
  EXPECT_THAT(Page("domains", records),
              HasSubstr("| `disk` | 1 of 1 | 0 | 1.25 (1.25 to 1.25) | 1.5 (1.5 to 1.5) |"));
}

TEST_F(StudyTest, RefinedMapsAreComparedWithThePlainOnesOfTheirMesh) {
  std::vector<nlohmann::json> records;
  for (const std::string mesh : {"a", "b"}) {
    for (const std::string method : {"plain", "mips"}) {
      nlohmann::json record = ReportRecord(mesh, method, 1);
      record["values"]["quasi_conformal_mean"] = method == "plain" ? 1.5
                                                 : mesh == "a"     ? 1.25
                                                                   : 1.125;
      record["values"]["quasi_conformal_max"] = method == "plain" ? 8 : 4;
      record["values"]["log_area_ratio_l2"] = 2;
      record["cpu_seconds"] = method == "plain" ? 2 : 3;
      records.push_back(record);
    }
  }
  nlohmann::json unmatched = ReportRecord("c", "mips", 1);
  unmatched["values"]["quasi_conformal_mean"] = 9;
  records.push_back(unmatched);
  EXPECT_THAT(Page("refinement", records),
              HasSubstr("| `mips` | 2 | 0.375 (0.25 to 0.5) | 0.5 (0.5 to 0.5) | 1 (1 to 1) | 1.5 "
                        "(1.5 to 1.5) |"));
}

TEST_F(StudyTest, LeversAreComparedWithTheIsometricBoundary) {
  std::vector<nlohmann::json> records;
  const auto add = [&](const char* name, const nlohmann::json& options, double l2, double qc) {
    nlohmann::json record = ReportRecord("a", name, 1);
    record["method"].update(options);
    record["values"].update({{"log_scale_l2", l2},
                             {"log_scale_max", 2 * l2},
                             {"symmetric_dirichlet", 3},
                             {"quasi_conformal_mean", qc},
                             {"quasi_conformal_p99", qc}});
    record["cpu_seconds"] = 2 * qc;
    records.push_back(record);
  };
  add("boundary,isometric", {{"boundary", "isometric"}}, 0.5, 1);
  add("cones,8", {{"cones", "greedy"}, {"cone_budget", 8}}, 0.1, 1.5);
  add("beyond,symmetric_dirichlet", {{"refine_map", "symmetric_dirichlet"}}, 0.05, 2);
  const std::string page = Page("levers", records);
  EXPECT_THAT(page, HasSubstr("| `8 cones` | 1 of 1 | 0.2 (0.2 to 0.2) | 0.2 (0.2 to 0.2) |"));
  EXPECT_THAT(page, HasSubstr("| `symmetric_dirichlet` | 1 of 1 | 0.1 (0.1 to 0.1) | 0.1 (0.1 to "
                              "0.1) | 1 (1 to 1) | 2.000 | 2.000 | 0 | 2 (2 to 2) |"));
}

TEST_F(StudyTest, CutsAreComparedWithThoseShortInTheImage) {
  std::vector<nlohmann::json> records;
  const auto add = [&](const char* name, const nlohmann::json& options, double length,
                       double visible, double qc, double used) {
    nlohmann::json record = ReportRecord("a", name, 1);
    record["method"].update(options);
    record["values"].update({{"cut_length", length},
                             {"visible_cut_length", visible},
                             {"quasi_conformal_mean", qc},
                             {"log_scale_l2", qc - 1},
                             {"patches", 1},
                             {"area_used", used}});
    record["cpu_seconds"] = 2;
    records.push_back(record);
  };
  add("rigid,cut_cost=flat_length", {{"cut_cost", "flat_length"}}, 2, 1, 1.5, 0.4);
  add("rigid,cut_cost=visibility", {{"cut_cost", "visibility"}}, 3, 0.25, 1.5, 0.3);
  add("free,cut_cost=length", {{"cut_cost", "length"}, {"seams", "free"}}, 1, 0.5, 1.2, 0.5);
  add("towards,cone_budget=8", {{"cut_cost", "length"}, {"cone_budget", 8}}, 4, 2, 1.1, 0.2);
  add("charts,least_charts=4", {{"cut_cost", "length"}, {"least_charts", 4}}, 5, 3, 1.05, 0.6);
  const std::string page = Page("cuts", records);
  EXPECT_THAT(page, HasSubstr("`rigid, visibility` is seen least, 0.25 of the visible length for "
                              "1.50 times the length"));
  EXPECT_THAT(page, HasSubstr("`free, towards 8 cones` leaves least area distortion, 0.20 of "
                              "the L2 norm of the log scale, for 2.00 times the length (1 of them "
                              "injective)"));
  EXPECT_THAT(page, HasSubstr("`4 charts` has the least mean quasi-conformal distortion (0.700), "
                              "and `4 charts` fills most of its square (1.50 times the area)"));
  EXPECT_THAT(page,
              HasSubstr("| `free, length` | 1 of 1 | 1 to 1 | 0.5 (0.5 to 0.5) | 0.5 (0.5 to "
                        "0.5) | 0.8 (0.8 to 0.8) | 0.4 (0.4 to 0.4) | 1.25 (1.25 to 1.25) |"));
}

TEST_F(StudyTest, BadRecordsAreRefusedAndNothingIsWritten) {
  ProgramResult refused = Study("scaling");
  EXPECT_EQ(refused.exit_status, 2);
  EXPECT_THAT(refused.output, HasSubstr("results.jsonl: does not exist; run the study's config"));
  folder_.Write("results.jsonl", "{\"torn\n");
  refused = Study("domains");
  EXPECT_EQ(refused.exit_status, 2);
  EXPECT_THAT(refused.output, HasSubstr("holds no record"));
  EXPECT_THAT(refused.output, Not(HasSubstr("Traceback")));
  EXPECT_FALSE(std::ifstream(folder_.Path("out.md")).good());
  EXPECT_EQ(Study("scalign").exit_status, 2);
}

nlohmann::json EnergyRecord(double n, const std::string& solver, const std::string& outcome,
                            int iterations) {
  nlohmann::json record = ReportRecord("bumpy_terrain-" + std::to_string(n), "own," + solver, 1);
  record["mesh"]["family"] = "bumpy_terrain";
  record["mesh"]["triangles"] = n;
  record["mesh"]["source"] = "bumpy_terrain triangles=1000 seed=1";
  record["method"] = {{"name", "own,energy_solver=" + solver},
                      {"energy", "circle_pattern"},
                      {"energy_solver", solver},
                      {"energy_start", "own"}};
  record["outcome"] = outcome;
  record["cpu_seconds"] = solver == "newton" ? 1e-6 * n : 3e-6 * n;
  record["values"] = {{"energy_iterations", iterations},
                      {"energy_factorizations", iterations},
                      {"energy_value", 1.5},
                      {"energy_difference", 1e-12}};
  return record;
}

TEST_F(StudyTest, EnergiesCountWhoEndsAtTheMinimum) {
  std::vector<nlohmann::json> records;
  for (const double n : {1e3, 1e4, 1e5}) {
    records.push_back(EnergyRecord(n, "newton", "ok", 4));
    records.push_back(EnergyRecord(n, "newton_cg", n < 1e5 ? "ok" : "not_converged", 9));
    records.push_back(EnergyRecord(n, "ceres_trust_region", "unsupported", 0));
  }
  const std::string page = Page("energies", records);
  EXPECT_THAT(page, HasSubstr("`newton` 3 of 3, `newton_cg` 2 of 3."));
  EXPECT_THAT(page, HasSubstr("| `newton_cg` | 2 of 3 | 9 (9 to 9) | 9 |"));
  EXPECT_THAT(page, HasSubstr("| 3 (-inf to inf) |"));
  EXPECT_THAT(page, HasSubstr("| `ceres LM` | no such form |"));
  EXPECT_THAT(page, HasSubstr("to the power 1.00"));
  EXPECT_THAT(page, HasSubstr("\"energy_value\": 1.5"));
}

TEST_F(StudyTest, ConesAreComparedAtEqualBudgets) {
  std::vector<nlohmann::json> records;
  for (int mesh = 0; mesh < 7; ++mesh) {
    nlohmann::json none = ReportRecord("m" + std::to_string(mesh), "none", 1);
    none["method"]["cone_budget"] = -1;
    none["values"]["log_area_ratio_l2"] = 2;
    none["cpu_seconds"] = 1;
    records.push_back(none);
    const std::pair<const char*, double> methods[] = {
        {"curvature_peaks", 1}, {"greedy", 0.5},   {"l1", 0.6},   {"reweighted", 0.6},
        {"moving", 0.25},       {"refined", 0.25}, {"angle", 0.8}};
    for (const auto& [name, area] : methods) {
      nlohmann::json record = none;
      record["method"] = {{"name", std::string(name) + ",cone_budget=8"}, {"cone_budget", 8}};
      record["values"]["log_area_ratio_l2"] = area;
      record["cpu_seconds"] = std::string(name) == "moving" ? 4 : 2;
      records.push_back(record);
    }
  }
  const std::string page = Page("cones", records);
  EXPECT_THAT(page, HasSubstr("On 7 meshes: with 8 cones `moving` has the least area distortion on "
                              "7 of 7 meshes, 0.12 of the distortion without cones, for 2 times"));
  EXPECT_THAT(page, HasSubstr("| `curvature_peaks` | 7 of 7 | 1.0000 | 2 (2 to 2) | 0 of 7 |"));
  EXPECT_THAT(page, HasSubstr("`moving` has 0.5 (0.5 to 0.5) times the figure of its start"));
  EXPECT_THAT(page, HasSubstr("no different within a thousandth on 7, worse on 0."));
}

TEST_F(StudyTest, ConvergenceFindsTheOrderOfEverySurface) {
  std::vector<nlohmann::json> records;
  for (const std::string boundary : {" boundary=known_map", ""}) {
    for (const double h : {0.1, 0.05, 0.025}) {
      nlohmann::json record =
          ReportRecord("cap" + boundary + std::to_string(h), "free,angle_objective=entropy", 1);
      record["mesh"]["family"] = "cap" + boundary;
      record["mesh"]["source"] = "spherical_cap triangles=100 seed=1" + boundary;
      record["method"]["angle_objective"] = "entropy";
      const double order = boundary.empty() ? 1 : 2;
      record["values"] = {{"edge_length", h},
                          {"known_map_rms_error", std::pow(h, order)},
                          {"known_map_max_error", 2 * std::pow(h, order)},
                          {"quasi_conformal_mean", 1 + h}};
      records.push_back(record);
      record["mesh"]["name"] = "limit" + record["mesh"]["name"].get<std::string>();
      record["mesh"]["family"] = "limit" + boundary;
      record["values"]["refined_map_rms_error"] = std::pow(h, 1.5);
      record["values"]["refined_map_max_error"] = std::pow(h, 1.5);
      if (boundary.empty()) records.push_back(record);
    }
  }
  const std::string page = Page("convergence", records);
  EXPECT_THAT(page, HasSubstr("Known map, its boundary angles: second order at least, the median "
                              "order in the mean square is 2.00"));
  EXPECT_THAT(page, HasSubstr("Known map, free boundary: first order at least"));
  EXPECT_THAT(page, HasSubstr("Smooth limit: first order at least, the median order in the mean "
                              "square is 1.50"));
  EXPECT_THAT(page, HasSubstr("1 of 1 sequences come nearer"));
}

TEST_F(StudyTest, PeersAreComparedWithOurProcess) {
  std::vector<nlohmann::json> records;
  for (int mesh = 0; mesh < 6; ++mesh) {
    for (const std::string program : {"circle_patterns", "bff"}) {
      nlohmann::json record =
          ReportRecord("m" + std::to_string(mesh), program, program == "bff" ? 3 : 1);
      record["method"] = {{"name", program}, {"peer", {program, "{in}", "{out}"}}};
      record["cpu_seconds"] = 1;
      record["peak_memory_mib"] = 50;
      record["values"]["flipped_triangles"] = program == "bff" && mesh == 0 ? 2 : 0;
      if (program == "bff" && mesh == 0) record["outcome"] = "invalid_map";
      records.push_back(record);
    }
  }
  const std::string page = Page("peers", records);
  EXPECT_THAT(page, HasSubstr("`circle_patterns` maps 6 of 6 meshes, none with a flipped triangle; "
                              "`bff` maps 5 of 6 meshes, with 1 times the mean quasi-conformal "
                              "distortion less 1 and 3 times the time"));
  EXPECT_THAT(page, HasSubstr("| `bff` | 5 ok, 1 invalid_map | 1 |"));
}

nlohmann::json DiskRecord(const std::string& mesh, const std::string& group, double distortion) {
  nlohmann::json record = ReportRecord(mesh, group, 1);
  record["values"].update({{"quasi_conformal_mean", 1 + distortion},
                           {"flipped_triangles", 0},
                           {"radii_gradient", 1e-12},
                           {"angle_gap", 1e-13},
                           {"angle_factorizations", 3}});
  return record;
}

TEST_F(StudyTest, DisksAndSurfacesSayWhatIsNotMapped) {
  std::vector<nlohmann::json> records = {
      DiskRecord("a", "input", 0.4), DiskRecord("a", "delaunay", 0.1),
      DiskRecord("b", "input", 0.4), DiskRecord("b", "delaunay", 0.2)};
  EXPECT_THAT(Page("disks", records),
              HasSubstr("Yes: 4 of 4 runs on 2 disks end in a map. 0 triangles"));
  EXPECT_THAT(Page("disks", records), HasSubstr("leave 0.38 times"));
  records.resize(1);
  records.push_back(DiskRecord("c", "input", 4));
  records.push_back(DiskRecord("lost", "input", 4));
  records.back()["outcome"] = "infeasible";
  const std::string page = Page("surfaces", records);
  EXPECT_THAT(page,
              HasSubstr("2 of 3 surfaces are mapped; the others say why: lost (infeasible)."));
  EXPECT_THAT(page, HasSubstr("above 2 on 1: c."));
}

}  // namespace
}  // namespace cirque

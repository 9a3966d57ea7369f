#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cirque/cones/cone.h"
#include "cirque/core/atomic_file.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/pipeline/cone_stages.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

ParameterizeOptions OnInput(const std::string& fit) {
  ParameterizeOptions options;
  options.triangulation = SolvedTriangulation::kInput;
  options.angle_objective = fit;
  return options;
}

FlatSurface MustFlatten(const IntrinsicTriangulation& metric, const ConeTargets& targets,
                        const ParameterizeOptions& options) {
  Certificate certificate;
  FlatSurface flat;
  const Status status =
      Flatten({MeasureSurface(metric.triangulation, metric.lengths), targets, options, {}},
              &certificate, &flat);
  EXPECT_TRUE(status.ok()) << status.message();
  return flat;
}

/// Against central differences: cone i gains what cone j loses.
void ExpectGradientIsRight(const std::string& generator, const std::string& fit) {
  SCOPED_TRACE(generator + " " + fit);
  const Surface surface = GeneratedSurface(generator, 500);
  const IntrinsicTriangulation metric =
      MakeIntrinsicDelaunay(surface.triangulation, MeasureEdgeLengths(surface));
  const Triangulation& t = metric.triangulation;
  std::vector<Cone> cones;
  const std::vector<bool> boundary = BoundaryVertices(t);
  const bool closed = BoundaryLoops(t).empty();
  const double total = closed ? 2 * kPi * EulerCharacteristic(t) : kPi;
  for (Index v = 10; cones.size() < 4; v += 47) {
    if (!boundary[v]) cones.push_back(ConeOfCurvature(v, total / 4));
  }
  const ConeTargets targets = *ConeTargetsOf(t, cones);
  const ParameterizeOptions options = OnInput(fit);
  const FlatSurface flat = MustFlatten(metric, targets, options);
  const Eigen::VectorXd gradient =
      AreaDistortionGradient(flat, targets, **AngleObjectives().Find(fit));
  const double step = 1e-5;
  const auto distortion = [&](double change) {
    ConeTargets moved = targets;
    moved.lower[cones[0].vertex] = moved.upper[cones[0].vertex] += change;
    if (closed) moved.lower[cones[2].vertex] = moved.upper[cones[2].vertex] -= change;
    return AreaDistortion(MustFlatten(metric, moved, options));
  };
  const double wanted = (distortion(step) - distortion(-step)) / (2 * step);
  const double found = gradient[cones[0].vertex] - (closed ? gradient[cones[2].vertex] : 0);
  EXPECT_GT(std::abs(wanted), 1e-3);
  EXPECT_NEAR(found, wanted, 1e-5 * (1 + std::abs(wanted)));
}

TEST(AreaDistortion, GradientIsThatOfFiniteDifferences) {
  for (const char* fit : {"quadratic", "barrier", "entropy"}) {
    for (const char* generator : {"blob", "double_torus", "bumpy_terrain"}) {
      ExpectGradientIsRight(generator, fit);
    }
  }
}

TEST(AreaDistortion, IsHalfTheSquareOfTheMeasureWithoutFlips) {
  const Surface surface = GeneratedSurface("blob", 800);
  ParameterizeOptions options = OnInput("quadratic");
  options.refine_map = "none";
  Parameterization map;
  ASSERT_TRUE(Parameterize(surface, {options, *DefaultTargets(surface)}, {}, &map).ok());
  const double l2 = map.certificate.distortion->log_area_ratio_l2;
  EXPECT_GT(l2, 0.1);
  EXPECT_NEAR(std::sqrt(2 * AreaDistortion(map.flat)), l2, 1e-8 * l2);
}

TEST(RefineCones, LowersTheRealisedDistortionAndKeepsGaussBonnet) {
  for (const char* name : {"blob", "torus", "double_torus", "bumpy_terrain"}) {
    SCOPED_TRACE(name);
    const Surface surface = GeneratedSurface(name, 1000);
    ParameterizeOptions options;
    options.cones = "greedy:fit=zero_at_cones";
    Parameterization start, refined;
    ASSERT_TRUE(Parameterize(surface, {options}, {}, &start).ok());
    options.refine_cones = 6;
    const Status status = Parameterize(surface, {options}, {}, &refined);
    ASSERT_TRUE(status.ok()) << status.message();
    const Certificate& certificate = refined.certificate;
    EXPECT_GE(certificate.cone_refinement->refinement_steps, 1);
    EXPECT_LT(certificate.cone_refinement->refinement_area_distortion_after,
              0.999 * certificate.cone_refinement->refinement_area_distortion_before);
    EXPECT_LT(certificate.distortion->log_area_ratio_l2,
              start.certificate.distortion->log_area_ratio_l2);
    EXPECT_EQ(certificate.layout->flipped_triangles, 0);
    const auto before = ConesOf(surface.triangulation, start.targets);
    const auto after = ConesOf(surface.triangulation, refined.targets);
    ASSERT_EQ(before.size(), after.size());
    double change = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_EQ(before[i].vertex, after[i].vertex);
      change += after[i].lower - before[i].lower;
    }
    if (BoundaryLoops(surface.triangulation).empty()) {
      EXPECT_NEAR(change, 0, 1e-9);
    }
  }
}

TEST(RefineCones, RangedConesStartWhereTheFitPutThem) {
  const Surface surface = GeneratedSurface("blob", 600);
  ParameterizeOptions options;
  options.cones = "greedy";
  options.cone_angles = "ranges:width=0.3";
  options.refine_cones = 3;
  Parameterization map;
  const Status status = Parameterize(surface, {options}, {}, &map);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_LE(map.certificate.cone_refinement->refinement_area_distortion_after,
            map.certificate.cone_refinement->refinement_area_distortion_before);
}

TEST(RepairCones, MovesThenWidensWhereTheProofPoints) {
  const Surface surface = GeneratedSurface("double_torus", 600);
  const Triangulation& t = surface.triangulation;
  const ConeTargets targets = *DefaultTargets(surface);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const IntrinsicSurface measured = MeasureSurface(surface.triangulation, lengths);
  const std::vector<Cone> cones = ConesOf(t, targets);
  InfeasibilityCertificate proof;
  proof.carrying_vertices = {cones[0].vertex};
  const ConeRepair widened = RepairCones(measured, targets, proof, 2);
  EXPECT_EQ(widened.widened, 1);
  EXPECT_EQ(widened.moved, 0);
  EXPECT_LT(widened.targets.lower[cones[0].vertex], cones[0].lower);
  EXPECT_GE(widened.targets.upper[cones[0].vertex], cones[0].upper);
  const ConeRepair moved = RepairCones(measured, targets, proof, 1);
  EXPECT_EQ(moved.widened, 0);
  EXPECT_EQ(ConesOf(t, moved.targets).size(), cones.size());
}

TEST(RepairCones, InfeasibleConesOfAFileStayAsTheyAre) {
  // Of five corners that add up to 4.6 pi each exceeds 0.6 pi: a triangle cannot have two of them.
  const Surface surface = GeneratedSurface("double_torus", 800);
  const Triangulation& t = surface.triangulation;
  const std::vector<Index> corners = CornersPerVertex(t);
  const std::string path = testing::TempDir() + "infeasible.cones";
  std::string text;
  for (Index h = 0; text.empty() && h < t.num_halfedges(); ++h) {
    if (corners[t.Tail(h)] != 5 || corners[t.Tip(h)] != 5) continue;
    const Index far = t.vertex[(h + t.num_halfedges() / 2) % t.num_halfedges()];
    text = fmt::format("{} 4.6\n{} 4.6\n{} 0.8\n", t.Tail(h) + 1, t.Tip(h) + 1, far + 1);
  }
  ASSERT_TRUE(WriteFileAtomically(path, text).ok());
  ParameterizeOptions options;
  options.cones = "given:file=" + path;
  options.triangulation = SolvedTriangulation::kInput;
  Parameterization map;
  const Status status = Parameterize(surface, {options}, {}, &map);
  EXPECT_EQ(status.code(), StatusCode::kInfeasible);
  EXPECT_FALSE(map.certificate.cone_repair.has_value());
  // What a repair makes of them has a map.
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const IntrinsicSurface measured = MeasureSurface(t, lengths);
  ConeTargets targets = map.targets;
  Status repaired = status;
  for (int round = 1; round <= kMostConeRepairs && !repaired.ok(); ++round) {
    targets = RepairCones(measured, targets, map.certificate.infeasibility, round).targets;
    repaired = Parameterize(surface, {options, targets}, {}, &map);
  }
  EXPECT_TRUE(repaired.ok()) << repaired.message();
  EXPECT_EQ(map.certificate.layout->flipped_triangles, 0);
}

}  // namespace
}  // namespace cirque

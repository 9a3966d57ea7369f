#include "cirque/layout/refine_patches.h"

#include <cmath>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "cirque/core/parallel.h"
#include "cirque/cuts/cut_graph.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/seams.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/renumbering.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

CornerUv FromAbove(const Surface& surface) {
  CornerUv uv;
  for (const Index v : surface.triangulation.vertex) {
    uv.value.push_back(surface.position[v].head<2>());
  }
  return uv;
}

void MoveVertex(const Triangulation& t, Index v, const Eigen::Vector2d& by, CornerUv* uv) {
  for (Index c = 0; c < t.num_halfedges(); ++c) {
    if (t.vertex[c] == v) uv->value[c] += by;
  }
}

PatchRefinement Refine(const IntrinsicSurface& surface, CornerUv* uv,
                       const RefinePatchesOptions& options = {}) {
  const Cut none{std::vector<bool>(surface.triangulation.num_edges(), false)};
  const auto done = RefineByPatches({surface, none, {}}, options, nullptr, uv);
  EXPECT_TRUE(done.ok()) << done.status().message();
  EXPECT_LE(done->after, done->before);
  EXPECT_TRUE(FlippedFaces(surface.triangulation, *uv).empty());
  return *done;
}

/// A surface with its measures.
struct Metric {
  explicit Metric(const Surface& of)
      : lengths(MeasureEdgeLengths(of)), surface(MeasureSurface(of.triangulation, lengths)) {}
  EdgeLengths lengths;
  IntrinsicSurface surface;
};

/// 20 x 20 squares with vertices (i, j), i and j in {5, 15}, next to the edge of their star.
struct Outliers {
  Surface strip = FlatStrip(20, 20);
  Metric metric{strip};
  CornerUv right = FromAbove(strip), uv = right;

  Outliers() {
    for (const int i : {5, 15}) {
      for (const int j : {5, 15}) MoveVertex(strip.triangulation, 21 * j + i, {0.4, 0.41}, &uv);
    }
  }
};

TEST(RefineByPatches, BringsPlantedOutliersBackAndTouchesNothingElse) {
  Outliers planted;
  const Triangulation& t = planted.strip.triangulation;
  const CornerUv start = planted.uv;
  const PatchRefinement done = Refine(planted.metric.surface, &planted.uv);
  EXPECT_GE(done.flagged, 4);
  EXPECT_EQ(done.patches, 4);
  EXPECT_EQ(done.rounds, 1);
  EXPECT_EQ(done.steps, 0);
  EXPECT_GT(done.before, 1e-3);
  EXPECT_LT(done.after, 1e-6 * done.before);
  int moved = 0;
  for (Index c = 0; c < t.num_halfedges(); ++c) {
    EXPECT_LT((planted.uv.value[c] - planted.right.value[c]).norm(), 1e-3);
    const Eigen::Vector2d from_centre = planted.right.value[c] - Eigen::Vector2d(10, 10);
    const Eigen::Vector2d from_outlier = from_centre.cwiseAbs() - Eigen::Vector2d(5, 5);
    // One edge around the outliers' triangles.
    if (from_outlier.cwiseAbs().maxCoeff() > 2) {
      EXPECT_EQ(planted.uv.value[c], start.value[c]);
    }
    moved += planted.uv.value[c] != start.value[c];
  }
  EXPECT_GT(moved, 0);
}

TEST(RefineByPatches, IsTheSameByOneThread) {
  Outliers first, second;
  Refine(first.metric.surface, &first.uv);
  const ThreadLimit one(1);
  Refine(second.metric.surface, &second.uv);
  EXPECT_EQ(first.uv.value, second.uv.value);
}

TEST(RefineByPatches, DoesNotDependOnNumbering) {
  Outliers planted;
  const Triangulation& t = planted.strip.triangulation;
  const Renumbering other = Renumber(t, 5);
  const EdgeLengths lengths = other.Lengths(t, planted.metric.lengths);
  CornerUv uv = planted.uv;
  for (Index c = 0; c < t.num_halfedges(); ++c) uv.value[other.halfedge[c]] = planted.uv.value[c];
  const PatchRefinement plain = Refine(planted.metric.surface, &planted.uv);
  const PatchRefinement renumbered = Refine(MeasureSurface(other.triangulation, lengths), &uv);
  EXPECT_EQ(plain.patch_steps, renumbered.patch_steps);
  for (Index c = 0; c < t.num_halfedges(); ++c) {
    EXPECT_LT((uv.value[other.halfedge[c]] - planted.uv.value[c]).norm(), 1e-10);
  }
}

TEST(RefineByPatches, LeavesAGoodMapAsItIs) {
  const Surface strip = FlatStrip(6, 6);
  CornerUv uv = FromAbove(strip);
  const PatchRefinement done = Refine(Metric(strip).surface, &uv);
  EXPECT_EQ(done.flagged + done.patches + done.rounds + done.patch_steps + done.steps, 0);
  EXPECT_EQ(uv.value, FromAbove(strip).value);
}

TEST(RefineByPatches, RefinesTheWholeMapWhereTheMeanAsksForIt) {
  const Surface strip = FlatStrip(10, 10);
  CornerUv stretched = FromAbove(strip);
  for (Eigen::Vector2d& p : stretched.value) p.x() *= 2;  // e = 1/2 everywhere
  CornerUv uv = stretched;
  const PatchRefinement done = Refine(Metric(strip).surface, &uv);
  EXPECT_NEAR(done.before, 0.5, 1e-12);
  EXPECT_EQ(done.patches, 0);
  EXPECT_GE(done.steps, 1);
  EXPECT_LT(done.after, 1e-3);
  uv = stretched;
  EXPECT_EQ(Refine(Metric(strip).surface, &uv, {.mean = 0.6, .once = 0.6}).steps, 0);
  EXPECT_EQ(uv.value, stretched.value);
}

TEST(RefineByPatches, AGoodMapGetsOneStepAsAWhole) {
  const Surface terrain = GeneratedSurface("bumpy_terrain", 2000);
  const Metric metric(terrain);
  for (const double once : {0.01, 1e9}) {
    CornerUv uv = FromAbove(terrain);
    const PatchRefinement done =
        Refine(metric.surface, &uv, {.rounds = 0, .mean = 1e9, .once = once});
    EXPECT_GT(done.before, 0.01);
    EXPECT_EQ(done.steps, once < 1 ? 1 : 0);
    EXPECT_LE(done.after, once < 1 ? 0.5 * done.before : done.before);
  }
}

TEST(RefineByPatches, TooManyVerticesInPatchesAreRefinedAsOneMap) {
  Outliers planted;
  const PatchRefinement done =
      Refine(planted.metric.surface, &planted.uv, {.share = 0.01, .mean = 1e-6});
  EXPECT_GE(done.flagged, 4);
  EXPECT_EQ(done.patches, 0);
  EXPECT_GE(done.steps, 1);
  EXPECT_LT(done.after, 0.1 * done.before);
}

TEST(RefineByPatches, WiderPatchesFollowWhereOutliersRemain) {
  const Surface terrain = GeneratedSurface("bumpy_terrain", 2000);
  const Metric metric(terrain);
  double before = 0;
  for (const int rounds : {0, 1, 2, 3}) {
    CornerUv uv = FromAbove(terrain);
    const PatchRefinement done = Refine(metric.surface, &uv,
                                        {.flag = 0,
                                         .medians = 8,
                                         .share = 1,
                                         .rounds = rounds,
                                         .round_decrease = 0,
                                         .mean = 1e9,
                                         .once = 1e9});
    EXPECT_LE(done.rounds, rounds);
    if (rounds == 0) {
      EXPECT_EQ(done.after, done.before);
    } else {
      EXPECT_LE(done.after, before);
    }
    if (rounds == 1) {
      EXPECT_LT(done.after, before);
    }
    before = done.after;
  }
}

TEST(RefineByPatches, SeamsStayCongruent) {
  for (const char* name : {"blob", "torus", "double_torus"}) {
    SCOPED_TRACE(name);
    const Surface surface = GeneratedSurface(name, 1200);
    const Triangulation& t = surface.triangulation;
    ParameterizeOptions options;
    options.refine_map = "none";
    Parameterization map;
    ASSERT_TRUE(Parameterize(surface, {options}, {}, &map).ok());
    const std::vector<Index> cones = ConeVertices(BoundaryVertices(t), map.targets);
    const auto seams = [&](const CornerUv& uv) {
      return MeasureSeams(t, map.cut, cones, map.flat.on_input.angles, uv);
    };
    const SeamReport before = seams(map.uv);
    // Patches everywhere, over the seams too.
    CornerUv uv = map.uv;
    const auto done = RefineByPatches(
        {Metric(surface).surface, map.cut, before.seams},
        {.flag = 0, .medians = 4, .share = 1, .round_decrease = 0, .mean = 1e9, .once = 1e9},
        nullptr, &uv);
    ASSERT_TRUE(done.ok());
    EXPECT_GE(done->patches, 2);
    EXPECT_LT(done->after, done->before);
    EXPECT_TRUE(FlippedFaces(t, uv).empty());
    int moved = 0;
    for (const Seam& seam : before.seams) {
      for (const Index h : seam.halfedges) {
        moved += uv.value[Triangulation::Next(h)] != map.uv.value[Triangulation::Next(h)];
      }
    }
    EXPECT_GT(moved, 0);
    const SeamReport after = seams(uv);
    EXPECT_LT(after.max_length_mismatch, 1e-8);
    EXPECT_LT(after.max_gap, 1e-8);
    EXPECT_LT(after.max_cone_mismatch, 1e-8);
    for (std::size_t i = 0; i < before.seams.size(); ++i) {
      const double turn = before.seams[i].rotation - after.seams[i].rotation;
      EXPECT_NEAR(std::remainder(turn, 2 * kPi), 0, 1e-9);
    }
  }
}

TEST(RefineByPatches, WithSeamsTheOneStepIsFromSixTimesTheMeanEnergyOn) {
  for (const auto& [faces, times] : {std::pair{1200, 6.0}, {600, 1.0}}) {
    const Surface surface = GeneratedSurface("blob", faces);
    ParameterizeOptions options;
    options.refine_map = "none";
    Parameterization map;
    ASSERT_TRUE(Parameterize(surface, {options}, {}, &map).ok());
    const std::vector<Index> cones =
        ConeVertices(BoundaryVertices(surface.triangulation), map.targets);
    const SeamReport report =
        MeasureSeams(surface.triangulation, map.cut, cones, map.flat.on_input.angles, map.uv);
    ASSERT_FALSE(report.seams.empty());
    const auto refine = [&](double once) {
      CornerUv uv = map.uv;
      return *RefineByPatches({Metric(surface).surface, map.cut, report.seams},
                              {.rounds = 0, .mean = 1e9, .once = once}, nullptr, &uv);
    };
    const double mean = refine(1e9).before;
    EXPECT_GT(mean, 0);
    EXPECT_EQ(refine(1.01 * mean / times).steps, 0) << faces;
    const PatchRefinement once = refine(0.99 * mean / times);
    EXPECT_EQ(once.steps, 1) << faces;
    EXPECT_LT(once.after, mean);
  }
}

TEST(RefineByPatches, EndsWhenCancelledAndLeavesTheMap) {
  Outliers planted;
  const CornerUv start = planted.uv;
  const Cut none{std::vector<bool>(planted.strip.triangulation.num_edges(), false)};
  const std::atomic<bool> cancelled = true;
  const auto done =
      RefineByPatches({planted.metric.surface, none, {}}, {}, &cancelled, &planted.uv);
  EXPECT_EQ(done.status().code(), StatusCode::kCancelled);
  EXPECT_EQ(planted.uv.value, start.value);
}

}  // namespace
}  // namespace cirque

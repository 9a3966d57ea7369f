// Layouts about several origins: rigid pieces of the flat metric, whatever the range of its lengths.
#include "cirque/pipeline/several_origins.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/exact_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// A layout of a flat surface that begins uncut.
struct Layout {
  explicit Layout(const Triangulation& triangulation, InputChart metric)
      : t(triangulation),
        flat(std::move(metric)),
        cut{std::vector<bool>(t.num_edges(), false)},
        layout(LayOutPatches(t, flat.angles, flat.lengths, cut)) {}

  Status Part(const std::vector<Index>& alone) {
    return LayOutAboutSeveralOrigins({t, flat, {}}, alone, &cut, &layout);
  }

  double LengthError() const {
    double worst = 0;
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      const Eigen::Vector2d along =
          layout.uv.value[Triangulation::Prev(h)] - layout.uv.value[Triangulation::Next(h)];
      const double length = flat.lengths.value[t.edge[h]];
      worst = std::max(worst, std::abs(along.stableNorm() - length) / length);
    }
    return worst;
  }

  Triangulation t;
  InputChart flat;
  Cut cut;
  PlanarLayout layout;
};

Layout LayoutOf(const Surface& flat) {
  const EdgeLengths lengths = MeasureEdgeLengths(flat);
  return Layout(flat.triangulation, {AnglesOf(flat), lengths, {}});
}

TEST(LayOutAboutSeveralOrigins, LeavesAloneWhatDoublesHold) {
  Layout strip = LayoutOf(FlatStrip(5, 3));
  const CornerUv before = strip.layout.uv;
  ASSERT_TRUE(strip.Part({}).ok());
  EXPECT_TRUE(strip.cut.IsEmpty());
  EXPECT_EQ(strip.layout.uv.value, before.value);
}

TEST(LayOutAboutSeveralOrigins, ALoneFaceLiesOnTheAxisAboutTheNearerEnd) {
  Layout strip = LayoutOf(FlatStrip(5, 3));
  const std::vector<Index> alone = {4, 13};
  ASSERT_TRUE(strip.Part(alone).ok());
  EXPECT_LT(strip.LengthError(), 1e-14);
  EXPECT_TRUE(FlippedFaces(strip.t, strip.layout.uv).empty());
  for (const Index f : alone) {
    const Index patch = strip.layout.patches.of_face[f];
    const auto& patches = strip.layout.patches.of_face;
    EXPECT_EQ(std::count(patches.begin(), patches.end(), patch), 1);
    int on_axis = 0, in_origin = 0;
    for (Index c = 3 * f; c < 3 * f + 3; ++c) {
      on_axis += strip.layout.uv.value[c].y() == 0;
      in_origin += strip.layout.uv.value[c].isZero(0);
    }
    EXPECT_EQ(on_axis, 2);
    EXPECT_EQ(in_origin, 1);
  }
}

/// Two triangles: one of sides 1, the other a cap of that height over a side of it.
Layout Cap(double height) {
  const Surface two = FlatStrip(1, 1);
  const Triangulation& t = two.triangulation;
  EdgeLengths lengths{Eigen::VectorXd::Ones(t.num_edges())};
  CornerAngles angles{Eigen::VectorXd::Constant(6, kPi / 3)};
  const Index base = t.twin[0] == kNone ? (t.twin[1] == kNone ? t.twin[2] : t.twin[1]) : t.twin[0];
  const double slope = std::atan2(height, 0.5);
  for (const Index h : {Triangulation::Next(base), Triangulation::Prev(base)}) {
    lengths.value[t.edge[h]] = 0.5 / std::cos(slope);
    angles.value[h] = slope;
  }
  angles.value[base] = kPi - 2 * slope;
  return Layout(t, {angles, lengths, {}});
}

TEST(LayOutAboutSeveralOrigins, HoldsACapOfAnyHeightAboveZero) {
  for (const double height : {1e-3, 1e-12, 1e-18, 1e-40, 1e-200}) {
    Layout cap = Cap(height);
    ASSERT_TRUE(cap.Part({}).ok()) << height;
    EXPECT_TRUE(FlippedFaces(cap.t, cap.layout.uv).empty()) << height;
    EXPECT_LT(cap.LengthError(), 1e-9) << height;
    EXPECT_EQ(cap.cut.IsEmpty(), height > 1e-16) << height;
  }
}

TEST(LayOutAboutSeveralOrigins, NamesAFaceWithoutArea) {
  Layout flat = Cap(0);
  const Status status = flat.Part({});
  EXPECT_EQ(status.code(), StatusCode::kUnrepresentable);
  EXPECT_THAT(std::string(status.message()), testing::HasSubstr("its sides are"));
}

/// Seen from the hole between them, each limb of a hundred rings is e^50 times smaller than the other's
/// beginning, in a place of its own.
TEST(ExactMap, OfTwoLimbsLiesAboutSeveralOrigins) {
  const Surface surface = TwoLimbs(200);
  MapRequest request;
  request.options.strict = true;
  EXPECT_EQ(MapSurface(surface, request).status().code(), StatusCode::kUnrepresentable);
  request.options.exact = true;
  const StatusOr<SurfaceMap> map = MapSurface(surface, request);
  ASSERT_TRUE(map.ok()) << map.status().message();
  EXPECT_GE(map->certificate.exact_map->exact_origins.value_or(1), 2);
  EXPECT_LT(map->certificate.exact_map->exact_seam_length_mismatch, 1e-8);
  ExpectExactMapIsAccepted(surface, *map);
}

}  // namespace
}  // namespace cirque

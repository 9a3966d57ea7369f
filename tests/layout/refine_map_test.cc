#include "cirque/layout/refine_map.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/opened_map.h"
#include "cirque/layout/stretch_sum.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

CornerUv UvOf(const Surface& flat) {
  CornerUv uv;
  for (const Index v : flat.triangulation.vertex) {
    uv.value.emplace_back(flat.position[v].x(), flat.position[v].y());
  }
  return uv;
}

/// The same corners with every vertex moved by up to `size` in both coordinates.
CornerUv Perturbed(const Triangulation& t, CornerUv uv, double size) {
  std::mt19937 random(3);
  std::vector<Eigen::Vector2d> move(t.num_vertices);
  for (Eigen::Vector2d& m : move) {
    const auto next = [&] {
      return size * (2.0 * random() / static_cast<double>(std::mt19937::max()) - 1);
    };
    m.x() = next();
    m.y() = next();
  }
  for (Index c = 0; c < t.num_halfedges(); ++c) uv.value[c] += move[t.vertex[c]];
  return uv;
}

Cut NoCut(const Triangulation& t) { return {std::vector<bool>(t.num_edges(), false)}; }

StatusOr<MapRefinement> Refine(const Surface& surface, const std::string& objective, int steps,
                               CornerUv* uv, const std::atomic<bool>* cancelled = nullptr) {
  const Triangulation& t = surface.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  return RefineMap({MeasureSurface(t, lengths), NoCut(t), {}}, *MapObjectives().Find(objective),
                   {.steps = steps, .decrease = 0}, cancelled, uv);
}

double AreaOf(const CornerUv& uv) {
  double twice = 0;
  for (std::size_t c = 0; c < uv.value.size(); c += 3) {
    Eigen::Matrix2d edges;
    edges << uv.value[c + 1] - uv.value[c], uv.value[c + 2] - uv.value[c];
    twice += edges.determinant();
  }
  return twice / 2;
}

TEST(EveryMapObjective, TakesAPerturbedPlanarMeshBackToASimilarity) {
  const Surface strip = FlatStrip(8, 6);
  for (const std::string& name : MapObjectives().Names()) {
    SCOPED_TRACE(name);
    CornerUv uv = Perturbed(strip.triangulation, UvOf(strip), 0.15);
    const double area = AreaOf(uv);
    ASSERT_TRUE(FlippedFaces(strip.triangulation, uv).empty());
    const StatusOr<MapRefinement> done = Refine(strip, name, 60, &uv);
    ASSERT_TRUE(done.ok()) << done.status().message();
    EXPECT_GT(done->before, 0.04);
    EXPECT_LT(done->after, 1e-12);
    EXPECT_NEAR(AreaOf(uv), area, 1e-12 * area);
    // All angles are those of the surface again: 45 and 90 degrees.
    const Eigen::Vector2d a = uv.value[1] - uv.value[0], b = uv.value[2] - uv.value[0];
    const double ratio = a.norm() / b.norm();
    const Eigen::Vector3d x = strip.position[strip.triangulation.vertex[1]] -
                              strip.position[strip.triangulation.vertex[0]];
    const Eigen::Vector3d y = strip.position[strip.triangulation.vertex[2]] -
                              strip.position[strip.triangulation.vertex[0]];
    EXPECT_NEAR(ratio, x.norm() / y.norm(), 1e-6);
    EXPECT_NEAR(a.dot(b) / (a.norm() * b.norm()), x.dot(y) / (x.norm() * y.norm()), 1e-6);
  }
}

TEST(RefineMap, LeavesAConformalMapAlone) {
  const Surface strip = FlatStrip(4, 4);
  CornerUv uv = UvOf(strip);
  const StatusOr<MapRefinement> done = Refine(strip, "mips", 5, &uv);
  ASSERT_TRUE(done.ok());
  EXPECT_LT(done->before, 1e-28);
  for (std::size_t c = 0; c < uv.value.size(); ++c) {
    EXPECT_LT((uv.value[c] - UvOf(strip).value[c]).norm(), 1e-14);
  }
}

TEST(RefineMap, AFaceWithoutAreaKeepsItsOrientation) {
  // A vertex of the surface lies on an edge; in the plane its triangle has an area.
  Surface strip = FlatStrip(4, 4);
  const CornerUv start = Perturbed(strip.triangulation, UvOf(strip), 0.1);
  const Index* corner = &strip.triangulation.vertex[0];
  strip.position[corner[0]] = 0.5 * (strip.position[corner[1]] + strip.position[corner[2]]);
  CornerUv uv = start;
  const StatusOr<MapRefinement> done = Refine(strip, "mips", 20, &uv);
  ASSERT_TRUE(done.ok());
  EXPECT_LT(done->after, done->before);
  EXPECT_TRUE(FlippedFaces(strip.triangulation, uv).empty());
}

TEST(RefineMap, HeldVerticesStay) {
  const Surface strip = FlatStrip(8, 8);
  const Triangulation& t = strip.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(strip);
  const IntrinsicSurface surface = MeasureSurface(t, lengths);
  const Cut none = NoCut(t);
  const CornerUv start = Perturbed(t, UvOf(strip), 0.1);
  for (const std::string& name : MapObjectives().Names()) {
    CornerUv uv = start;
    const auto done = RefineMap({surface, none, {}, surface.boundary}, *MapObjectives().Find(name),
                                {}, nullptr, &uv);
    ASSERT_TRUE(done.ok());
    EXPECT_LT(done->after, 0.9 * done->before);
    for (Index c = 0; c < t.num_halfedges(); ++c) {
      EXPECT_EQ(uv.value[c] == start.value[c], surface.boundary[t.vertex[c]]) << c;
    }
  }
}

/// exp(0.4 z).
void Exponentiate(CornerUv* uv) {
  for (Eigen::Vector2d& p : uv->value) {
    p = std::exp(0.4 * p.x()) * Eigen::Vector2d(std::cos(0.4 * p.y()), std::sin(0.4 * p.y()));
  }
}

TEST(RefineMap, ASeamOverManyScalesStaysCongruentAndLetsOtherVerticesMove) {
  // A slit whose edges are from 1e-13 to 1e-2 of the image.
  const Surface strip = FlatStrip(80, 4);
  const Triangulation& t = strip.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(strip);
  const IntrinsicSurface surface = MeasureSurface(t, lengths);
  Cut slit = NoCut(t);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Eigen::Vector3d &a = strip.position[t.Tail(h)], &b = strip.position[t.Tip(h)];
    const bool on_line = a.y() == 2 && b.y() == 2;
    if (on_line && std::min(a.x(), b.x()) >= 3 && std::max(a.x(), b.x()) <= 74) {
      slit.edge[t.edge[h]] = true;
    }
  }
  CornerUv uv = Perturbed(t, UvOf(strip), 0.15);
  Exponentiate(&uv);
  const SeamReport before = MeasureSeams(t, slit, {}, surface.angles, uv);
  ASSERT_EQ(before.seams.size(), 1u);
  for (const std::string& name : MapObjectives().Names()) {
    CornerUv refined = uv;
    const auto done = RefineMap({surface, slit, before.seams}, *MapObjectives().Find(name), {},
                                nullptr, &refined);
    ASSERT_TRUE(done.ok());
    EXPECT_LT(done->after, 0.9 * done->before);
    EXPECT_TRUE(FlippedFaces(t, refined).empty());
    const SeamReport after = MeasureSeams(t, slit, {}, surface.angles, refined);
    EXPECT_LT(after.max_length_mismatch, 1e-8);
    EXPECT_LT(after.max_gap, 1e-8);
  }
}

TEST(RefineMap, ScalesOfTwentyEightOrdersOfMagnitudeImproveAlike) {
  // exp(0.4 z) of a strip: the matrix's diagonal, as the inverse square of the image, spans e^64.
  const Surface strip = FlatStrip(80, 3);
  const Triangulation& t = strip.triangulation;
  CornerUv uv = Perturbed(t, UvOf(strip), 0.15);
  Exponentiate(&uv);
  ASSERT_TRUE(FlippedFaces(t, uv).empty());
  const EdgeLengths lengths = MeasureEdgeLengths(strip);
  const IntrinsicSurface surface = MeasureSurface(t, lengths);
  const Cut none = NoCut(t);
  const MapObjective mips = *MapObjectives().Find("mips");
  const std::vector<double> before = OpenedMap({surface, none, {}}, uv, 0).Energies(mips);
  ASSERT_TRUE(Refine(strip, "mips", 2, &uv).ok());
  const std::vector<double> after = OpenedMap({surface, none, {}}, uv, 0).Energies(mips);
  EXPECT_TRUE(FlippedFaces(t, uv).empty());
  // Steps move every quarter of the strip.
  for (double quarter = 0; quarter < 80; quarter += 20) {
    double sum_before = 0, sum_after = 0;
    for (Index f = 0; f < t.num_faces(); ++f) {
      const double x = strip.position[t.vertex[3 * f]].x();
      if (x < quarter || x >= quarter + 20) continue;
      sum_before += before[f], sum_after += after[f];
    }
    EXPECT_LT(sum_after, 0.95 * sum_before) << quarter;
  }
}

TEST(RefineMap, FacesOfAMillionthOfTheirHeightComeBack) {
  const Surface strip = FlatStrip(4, 4);
  CornerUv uv = UvOf(strip);
  for (Index c = 0; c < strip.triangulation.num_halfedges(); ++c) {
    if (strip.triangulation.vertex[c] % 5 == 1) uv.value[c].x() += 1 - 1e-6;
    if (strip.triangulation.vertex[c] % 5 == 3) uv.value[c].y() *= 1 + 1e-6;
  }
  ASSERT_TRUE(FlippedFaces(strip.triangulation, uv).empty());
  const StatusOr<MapRefinement> done = Refine(strip, "mips", 60, &uv);
  ASSERT_TRUE(done.ok());
  EXPECT_GT(done->before, 1e4);
  EXPECT_LT(done->after, 1e-6);
}

StatusOr<MapRefinement> Stretch(const SeamedSurface& of, const std::string& energy, int steps,
                                CornerUv* uv, const std::atomic<bool>* cancelled = nullptr) {
  return RefineStretch(of, *StretchEnergies().Find(energy), {.steps = steps, .decrease = 0},
                       cancelled, uv);
}

TEST(EveryStretchEnergy, TakesAPerturbedPlanarMeshBackToAnIsometry) {
  const Surface strip = FlatStrip(8, 6);
  const Triangulation& t = strip.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(strip);
  const IntrinsicSurface surface = MeasureSurface(t, lengths);
  const Cut none = NoCut(t);
  for (const std::string& name : StretchEnergies().Names()) {
    SCOPED_TRACE(name);
    CornerUv uv = Perturbed(t, UvOf(strip), 0.15);
    for (Eigen::Vector2d& p : uv.value) p *= 3;  // and of another size
    const double area = AreaOf(uv);
    const StatusOr<MapRefinement> done = Stretch({surface, none, {}}, name, 60, &uv);
    ASSERT_TRUE(done.ok()) << done.status().message();
    EXPECT_GT(done->before, 0.02);
    EXPECT_LT(done->after, 1e-12);
    EXPECT_TRUE(FlippedFaces(t, uv).empty());
    EXPECT_NEAR(AreaOf(uv), area, 1e-12 * area);
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      const double image =
          (uv.value[Triangulation::Prev(h)] - uv.value[Triangulation::Next(h)]).norm();
      const double scale = std::sqrt(area / AreaOf(UvOf(strip)));
      EXPECT_NEAR(image, scale * lengths.value[t.edge[h]], 1e-5);
    }
  }
}

TEST(EveryStretchEnergy, EndsWhereNoMoveOfAVertexLowersIt) {
  const Surface cap = GeneratedSurface("hemisphere", 200);
  const Triangulation& t = cap.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(cap);
  const IntrinsicSurface surface = MeasureSurface(t, lengths);
  const Cut none = NoCut(t);
  CornerUv start;
  for (const Index v : t.vertex) start.value.push_back(cap.position[v].head<2>());
  ASSERT_TRUE(FlippedFaces(t, start).empty());
  for (const std::string& name : StretchEnergies().Names()) {
    SCOPED_TRACE(name);
    CornerUv uv = start;
    const StatusOr<MapRefinement> done = Stretch({surface, none, {}}, name, 200, &uv);
    ASSERT_TRUE(done.ok());
    EXPECT_LT(done->after, 0.8 * done->before);
    EXPECT_TRUE(done->at_rest);
    EXPECT_TRUE(FlippedFaces(t, uv).empty());
    const StretchEnergy energy = *StretchEnergies().Find(name);
    OpenedMap map({surface, none, {}}, uv, 0);
    const double unit = BestUnit(map.faces(), energy, map.z());
    const double least = StretchOf(map.faces(), energy, unit, map.z());
    EXPECT_NEAR(least, done->after, 1e-10 * least);
    const double size = 1e-3 * std::sqrt(AreaOf(uv) / t.num_faces());
    for (Index v = 0; v < t.num_vertices; v += 7) {
      for (const std::complex<double> move : {std::complex<double>(size, 0), {0, size}}) {
        const auto at = [&](double sign) {
          Eigen::VectorXcd z = map.z();
          z[v] += sign * move;
          return StretchOf(map.faces(), energy, unit, z);
        };
        EXPECT_GT(at(1) + 1e-7 * least, least);
        EXPECT_GT(at(-1) + 1e-7 * least, least);
      }
    }
  }
}

TEST(EveryStretchEnergy, KeepsSeamsCongruentAndHeldVerticesWhereTheyAre) {
  const Surface strip = FlatStrip(12, 8);
  const Surface bent = Moved(strip, [](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(x.x(), x.y(), 2 * std::sin(0.5 * x.x()) * std::cos(0.7 * x.y()));
  });
  const Triangulation& t = strip.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(bent);
  const IntrinsicSurface surface = MeasureSurface(t, lengths);
  Cut slit = NoCut(t);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Eigen::Vector3d &a = strip.position[t.Tail(h)], &b = strip.position[t.Tip(h)];
    if (a.y() == 4 && b.y() == 4 && std::min(a.x(), b.x()) >= 3 && std::max(a.x(), b.x()) <= 9) {
      slit.edge[t.edge[h]] = true;
    }
  }
  const CornerUv start = Perturbed(t, UvOf(strip), 0.1);
  const SeamReport before = MeasureSeams(t, slit, {}, surface.angles, start);
  ASSERT_EQ(before.seams.size(), 1u);
  std::vector<bool> held(t.num_vertices, false);
  held[0] = held[5] = true;
  for (const std::string& name : StretchEnergies().Names()) {
    SCOPED_TRACE(name);
    CornerUv uv = start;
    const auto done = Stretch({surface, slit, before.seams, held}, name, 40, &uv);
    ASSERT_TRUE(done.ok());
    EXPECT_LT(done->after, 0.9 * done->before);
    EXPECT_TRUE(FlippedFaces(t, uv).empty());
    const SeamReport after = MeasureSeams(t, slit, {}, surface.angles, uv);
    EXPECT_LT(after.max_length_mismatch, 1e-8);
    EXPECT_LT(after.max_gap, 1e-8);
    for (Index c = 0; c < t.num_halfedges(); ++c) {
      EXPECT_EQ(uv.value[c] == start.value[c], held[t.vertex[c]]) << c;
    }
  }
}

TEST(RefineStretch, MoreWeightOnAreaKeepsAreasBetterAndAnglesWorse) {
  const Surface cap = GeneratedSurface("hemisphere", 400);
  const Triangulation& t = cap.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(cap);
  const IntrinsicSurface surface = MeasureSurface(t, lengths);
  const Cut none = NoCut(t);
  double areas_before = 1e300, angles_before = -1;
  for (const double weight : {0.0, 0.2, 0.5, 0.8}) {
    CornerUv uv;
    for (const Index v : t.vertex) uv.value.push_back(cap.position[v].head<2>());
    const auto done =
        RefineStretch({surface, none, {}}, *StretchEnergies().Find("area"),
                      {.steps = 200, .decrease = 1e-9, .weight = weight}, nullptr, &uv);
    ASSERT_TRUE(done.ok());
    StretchEnergy angles = *StretchEnergies().Find("area"), areas = angles;
    angles.weight = 0, areas.weight = 1;
    const OpenedMap map({surface, none, {}}, uv, 0);
    OpenedMap copy = map;
    const double of_areas =
        StretchOf(map.faces(), areas, BestUnit(map.faces(), areas, copy.z()), copy.z());
    const double of_angles = StretchOf(map.faces(), angles, 1, copy.z());
    EXPECT_LT(of_areas, areas_before);
    EXPECT_GT(of_angles, angles_before);
    areas_before = of_areas, angles_before = of_angles;
  }
}

TEST(RefineStretch, EndsWhenCancelledAndLeavesTheMap) {
  const Surface strip = FlatStrip(4, 4);
  const Triangulation& t = strip.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(strip);
  const Cut none = NoCut(t);
  const CornerUv start = Perturbed(t, UvOf(strip), 0.1);
  CornerUv uv = start;
  const std::atomic<bool> cancelled = true;
  const auto done = Stretch({MeasureSurface(t, lengths), none, {}}, "arap", 5, &uv, &cancelled);
  EXPECT_EQ(done.status().code(), StatusCode::kCancelled);
  EXPECT_EQ(uv.value, start.value);
}

TEST(RefineMap, EndsWhenCancelledAndLeavesTheMap) {
  const Surface strip = FlatStrip(4, 4);
  const CornerUv start = Perturbed(strip.triangulation, UvOf(strip), 0.1);
  CornerUv uv = start;
  const std::atomic<bool> cancelled = true;
  EXPECT_EQ(Refine(strip, "mips", 5, &uv, &cancelled).status().code(), StatusCode::kCancelled);
  EXPECT_EQ(uv.value, start.value);
}

}  // namespace
}  // namespace cirque

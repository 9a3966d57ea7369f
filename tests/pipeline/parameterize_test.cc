#include "cirque/pipeline/parameterize.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cirque/core/parallel.h"
#include "cirque/cuts/shortest_path.h"
#include "cirque/generators/generators.h"
#include "cirque/math/similarity.h"
#include "cirque/mesh/preflight.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/surfaces.h"
#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

Status FreeBoundaryMap(const Surface& surface, const ParameterizeOptions& options,
                       const SolveControl& control, Parameterization* map) {
  const StatusOr<ConeTargets> targets = DefaultTargets(surface);
  if (!targets.ok()) return targets.status();
  return Parameterize(surface, {options, *targets}, control, map);
}

Parameterization Flatten(const Surface& surface, StatusCode wanted = StatusCode::kOk,
                         const ParameterizeOptions& options = {}) {
  Parameterization map;
  const Status status = FreeBoundaryMap(surface, options, {}, &map);
  EXPECT_EQ(status.code(), wanted) << status.message();
  EXPECT_EQ(map.certificate.outcome, ToString(wanted));
  return map;
}

TEST(Parameterize, PlanarDelaunayMeshComesBackUpToSimilarity) {
  const Surface patch = GeneratedSurface("flat_delaunay_patch", 4000);
  ParameterizeOptions options;
  options.epsilon =
      1e-9;  // near-cocircular quads of the patch may be flatter than the default margin
  Parameterization map;
  ASSERT_TRUE(FreeBoundaryMap(patch, options, {}, &map).ok());
  std::vector<Eigen::Vector2d> wanted;
  for (const Index v : patch.triangulation.vertex) wanted.push_back(patch.position[v].head<2>());
  EXPECT_LT(FitSimilarity(map.uv.value, wanted).max_error, 1e-9);
}

TEST(Parameterize, GeneratedDisksHaveCertifiedMaps) {
  for (const char* name :
       {"bumpy_terrain", "spherical_cap", "enneper_patch", "hemisphere", "capped_tube"}) {
    SCOPED_TRACE(name);
    const Parameterization map = Flatten(GeneratedSurface(name, 1500));
    const Certificate& certificate = map.certificate;
    EXPECT_EQ(certificate.layout->flipped_triangles, 0);
    EXPECT_LE(certificate.radii->radii_gradient, 1e-9);
    EXPECT_LE(certificate.angle_fit->vertex_sum_residual, 1e-8);
    EXPECT_LE(certificate.radii->radii_gap, 1e-8);
    EXPECT_LE(certificate.angle_fit->angle_gap, 1e-8);
    EXPECT_LE(certificate.layout->layout_closure, 1e-7);
    EXPECT_GE(certificate.distortion->quasi_conformal_mean, 1);
    EXPECT_LT(certificate.distortion->quasi_conformal_mean, 1.2);
    EXPECT_EQ(map.certificate.overlap, "injective");
  }
}

TEST(Parameterize, ImageHasTheAreaOfTheSurface) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 500);
  const Parameterization map = Flatten(surface);
  double image = 0, source = 0;
  for (Index f = 0; f < surface.triangulation.num_faces(); ++f) {
    const auto corner = [&](int k) {
      return surface.position[surface.triangulation.vertex[3 * f + k]];
    };
    source += 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
    const Eigen::Vector2d a = map.uv.value[3 * f + 1] - map.uv.value[3 * f];
    const Eigen::Vector2d b = map.uv.value[3 * f + 2] - map.uv.value[3 * f];
    image += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  EXPECT_NEAR(image / source, 1, 1e-9);
}

TEST(Parameterize, KleetopeIsRefusedWithItsProofAndNoUv) {
  ParameterizeOptions raw;
  raw.triangulation = SolvedTriangulation::kInput;
  const Parameterization map =
      Flatten(Kleetope(GeneratedSurface("bumpy_terrain", 200)), StatusCode::kInfeasible, raw);
  EXPECT_TRUE(map.uv.value.empty());
  const auto json = nlohmann::json::parse(map.certificate.ToJson());
  EXPECT_EQ(json["outcome"], "infeasible");
  EXPECT_FALSE(json["infeasibility"]["face_multiplier"].empty());
}

TEST(Parameterize, LeastSquaresLayoutIsTheSameMap) {
  const Surface surface = GeneratedSurface("blob", 800);
  ParameterizeOptions options;
  options.layout = LayoutMethod::kLeastSquares;
  const Parameterization smooth = Flatten(surface, StatusCode::kOk, options);
  const Parameterization tree = Flatten(surface);
  EXPECT_LT(FitSimilarity(smooth.uv.value, tree.uv.value).max_error, 1e-7);
}

TEST(Parameterize, SeveralPatchesArePackedIntoTheUnitSquare) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 600);
  const Triangulation& t = surface.triangulation;
  const std::vector<Index> loop = BoundaryLoops(t).front();
  const Index from = t.Tail(loop.front()), to = t.Tail(loop[loop.size() / 2]);
  const StatusOr<Cut> cut =
      CutAlongShortestPaths(t, MeasureEdgeLengths(surface).value, {{from, to}});
  ASSERT_TRUE(cut.ok()) << cut.status().message();
  Parameterization map;
  const Status status = Parameterize(surface, {{}, FreeBoundaryTargets(t), *cut}, {}, &map);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_GE(map.certificate.layout->patches, 2);
  EXPECT_EQ(map.certificate.overlap, "injective");
  for (const Eigen::Vector2d& p : map.uv.value) {
    EXPECT_GE(p.minCoeff(), -1e-12);
    EXPECT_LE(p.maxCoeff(), 1 + 1e-12);
  }
}

TEST(Parameterize, ACutThatMissesConesIsLedThroughThem) {
  const Surface surface = GeneratedSurface("sphere", 400);
  const Triangulation& t = surface.triangulation;
  Cut one_edge = {std::vector<bool>(t.num_edges(), false)};
  one_edge.edge[0] = true;
  Parameterization map;
  const Status status = Parameterize(surface, {{}, *DefaultTargets(surface), one_edge}, {}, &map);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_TRUE(map.cut.edge[0]);
  EXPECT_EQ(map.certificate.layout->given_cut_edges, 1);
  EXPECT_GT(map.certificate.layout->further_cut_edges, 1);
  EXPECT_EQ(map.certificate.layout->flipped_triangles, 0);
}

/// Opens a closed surface along a path from its first vertex to that farthest from it.
Parameterization OpenedAlongAPath(const char* generator) {
  const Surface surface = GeneratedSurface(generator, 600);
  const Triangulation& t = surface.triangulation;
  const auto distance = [&](Index v) { return (surface.position[v] - surface.position[0]).norm(); };
  Index far = 0;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (distance(v) > distance(far)) far = v;
  }
  const Cut cut = *CutAlongShortestPaths(t, MeasureEdgeLengths(surface).value, {{0, far}});
  Parameterization map;
  const Status status = Parameterize(surface, {{}, {}, cut}, {}, &map);
  EXPECT_TRUE(status.ok()) << generator << ": " << status.message();
  for (Index e = 0; e < t.num_edges(); ++e) EXPECT_TRUE(!cut.edge[e] || map.cut.edge[e]);
  EXPECT_EQ(map.certificate.layout->given_cut_edges,
            std::count(cut.edge.begin(), cut.edge.end(), true));
  EXPECT_EQ(map.certificate.layout->cones, 0);
  return map;
}

TEST(Parameterize, AClosedSurfaceIsOpenedAlongTheGivenCutWithoutCones) {
  // A sphere is a disk then, and all of the boundary is free; a torus needs more.
  EXPECT_EQ(OpenedAlongAPath("sphere").certificate.layout->further_cut_edges, 0);
  EXPECT_GT(OpenedAlongAPath("torus").certificate.layout->further_cut_edges, 4);
}

TEST(Parameterize, ACutThroughThePolygonsIsRefusedByName) {
  const Surface torus = SurfaceOf(testing::Torus());
  const std::vector<bool> inside = EdgesInsidePolygons(torus);
  Parameterization map;
  const Status status = Parameterize(torus, {{}, {}, Cut{inside}}, {}, &map);
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_NE(status.message().find("inside of faces 0, 1, 2"), std::string::npos)
      << status.message();
}

TEST(Parameterize, FlipsRemoveWhatMakesAKleetopeInfeasible) {
  const Parameterization map = Flatten(Kleetope(GeneratedSurface("bumpy_terrain", 200)));
  EXPECT_GT(map.certificate.triangulation->flips, 100);
}

TEST(Parameterize, SurfacesOfEveryTopologyAreCutAndMapped) {
  for (const char* name : {"sphere", "blob", "torus", "double_torus", "annulus", "catenoid"}) {
    SCOPED_TRACE(name);
    const Surface surface = GeneratedSurface(name, 900);
    const Parameterization map = Flatten(surface);
    const Certificate& certificate = map.certificate;
    EXPECT_EQ(certificate.layout->flipped_triangles, 0);
    EXPECT_LE(certificate.layout->layout_closure, 1e-7);
    EXPECT_LE(certificate.seams->seam_length_mismatch, 1e-8);
    EXPECT_LE(certificate.seams->seam_rotation_mismatch, 1e-8);
    EXPECT_LE(certificate.seams->cone_rotation_mismatch, 1e-8);
    EXPECT_LE(certificate.seams->seam_gap, 1e-7);
    EXPECT_GE(certificate.seams->seams, 1);
    EXPECT_LT(certificate.distortion->quasi_conformal_mean, 1.2);
    // Opened along the cut it is a disk.
    EXPECT_EQ(EulerCharacteristic(CutOpen(surface.triangulation, map.cut)), 1);
  }
}

TEST(Parameterize, DelaunayFlipsBringAScrambledPatchBackToItsPlane) {
  // On its own connectivity the terrain is distorted by the margin; flips never make that worse.
  const Surface surface = GeneratedSurface("bumpy_terrain", 3000);
  ParameterizeOptions raw;
  raw.triangulation = SolvedTriangulation::kInput;
  Parameterization on_input;
  ASSERT_TRUE(FreeBoundaryMap(surface, raw, {}, &on_input).ok());
  const Parameterization flipped = Flatten(surface);
  EXPECT_GT(flipped.certificate.triangulation->flips, 0);
  EXPECT_EQ(flipped.certificate.triangulation->flipped_in_chart, 0);
  EXPECT_LE(flipped.certificate.distortion->quasi_conformal_mean,
            on_input.certificate.distortion->quasi_conformal_mean + 1e-6);
}

TEST(Parameterize, LengthsAloneWillDo) {
  const Surface surface = GeneratedSurface("spherical_cap", 300);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  Parameterization of_surface, of_metric;
  ASSERT_TRUE(Parameterize(surface, {}, {}, &of_surface).ok());
  ASSERT_TRUE(Parameterize(surface.triangulation, lengths, {}, {}, &of_metric).ok());
  EXPECT_EQ(of_metric.uv.value, of_surface.uv.value);
}

TEST(Parameterize, AFlatMetricIsLaidOutAsItIs) {
  const Surface strip = FlatStrip(5, 3);
  const EdgeLengths lengths = MeasureEdgeLengths(strip);
  Parameterization map;
  ASSERT_TRUE(LayOutFlatMetric(strip.triangulation, lengths, nullptr, &map).ok());
  std::vector<Eigen::Vector2d> wanted;
  for (const Index v : strip.triangulation.vertex) wanted.push_back(strip.position[v].head<2>());
  EXPECT_LT(FitSimilarity(map.uv.value, wanted).max_error, 1e-12);
  EXPECT_NEAR(map.certificate.distortion->quasi_conformal_max, 1, 1e-12);
  EXPECT_FALSE(map.certificate.angle_fit.has_value());  // nothing was solved
  EXPECT_EQ(map.certificate.layout->cones, 0);
}

TEST(Parameterize, ConesOfAFlatMetricAreFoundAndCutThrough) {
  // The surface of a regular octahedron is flat but for six cones of four triangles each.
  const Surface octahedron = RegularPolyhedron(8);
  const EdgeLengths lengths = MeasureEdgeLengths(octahedron);
  Parameterization map;
  ASSERT_TRUE(LayOutFlatMetric(octahedron.triangulation, lengths, nullptr, &map).ok());
  EXPECT_EQ(map.certificate.layout->cones, 6);
  EXPECT_EQ(EulerCharacteristic(CutOpen(octahedron.triangulation, map.cut)), 1);
  EXPECT_NEAR(map.certificate.distortion->quasi_conformal_max, 1, 1e-12);
  for (Index h = 0; h < octahedron.triangulation.num_halfedges(); ++h) {
    const Eigen::Vector2d edge = map.uv.value[Triangulation::Next(h)] - map.uv.value[h];
    EXPECT_NEAR(edge.norm(), std::sqrt(2), 1e-12);
  }
}

TEST(Parameterize, TheCutGivenIsTheCutTaken) {
  const Surface surface = GeneratedSurface("torus", 300);
  Parameterization first;
  ASSERT_TRUE(Parameterize(surface, {}, {}, &first).ok());
  Parameterization second;
  ParameterizeOptions rigid;
  rigid.seams = SeamKind::kRigid;
  ASSERT_TRUE(Parameterize(surface, {rigid, {}, first.cut}, {}, &second).ok());
  EXPECT_EQ(second.cut.edge, first.cut.edge);
  EXPECT_EQ(second.uv.value, first.uv.value);
}

/// The edges of an open path from a vertex over `count` edges, each to a vertex not met before.
Cut PathFrom(const Triangulation& t, Index start, int count) {
  Cut cut{std::vector<bool>(t.num_edges(), false)};
  std::vector<bool> met(t.num_vertices, false);
  Index at = start;
  for (int step = 0; step < count; ++step) {
    met[at] = true;
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      if (t.Tail(h) != at || met[t.Tip(h)]) continue;
      cut.edge[t.edge[h]] = true;
      at = t.Tip(h);
      break;
    }
  }
  return cut;
}

TEST(Parameterize, ACutThatIsGivenAloneOpensTheSurface) {
  for (const char* name : {"sphere", "torus", "bumpy_terrain"}) {
    SCOPED_TRACE(name);
    const Surface surface = GeneratedSurface(name, 500);
    const Triangulation& t = surface.triangulation;
    const Cut given = PathFrom(t, t.num_vertices / 2, 4);
    Parameterization map;
    const Status status = Parameterize(surface, {{}, {}, given}, {}, &map);
    ASSERT_TRUE(status.ok()) << status.message();
    EXPECT_TRUE(FlippedFaces(t, map.uv).empty());
    for (Index e = 0; e < t.num_edges(); ++e) EXPECT_TRUE(map.cut.edge[e] || !given.edge[e]);
    // A torus is no disk yet.
    EXPECT_EQ(map.cut.edge == given.edge, std::string(name) != "torus");
    EXPECT_EQ(EulerCharacteristic(CutOpen(t, map.cut)), 1);
    EXPECT_EQ(map.certificate.layout->cones, 0);
  }
}

TEST(Parameterize, ACanComesApartAtItsSeams) {
  // The side of a can cut from its rim to its bottom, and the bottom off: developable.
  constexpr int kSides = 16;
  PolygonSoup soup;
  for (int ring = 0; ring < 2; ++ring) {
    for (int i = 0; i < kSides; ++i) {
      soup.position.emplace_back(std::cos(2 * kPi * i / kSides), std::sin(2 * kPi * i / kSides),
                                 ring);
    }
  }
  soup.position.emplace_back(0, 0, 0);
  const auto add = [&](Index a, Index b, Index c) {
    soup.corner.insert(soup.corner.end(), {a, b, c});
    soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
  };
  for (Index i = 0; i < kSides; ++i) {
    const Index j = (i + 1) % kSides;
    add(i, j, kSides + i), add(j, kSides + j, kSides + i), add(j, i, 2 * kSides);
  }
  const Surface can = SurfaceOf(soup);
  const Triangulation& t = can.triangulation;
  Cut seams{std::vector<bool>(t.num_edges(), false)};
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index a = std::min(t.Tail(h), t.Tip(h)), b = std::max(t.Tail(h), t.Tip(h));
    const bool rim = b < kSides;
    if (rim || (a == 0 && b == kSides)) seams.edge[t.edge[h]] = true;
  }
  ParameterizeOptions options;
  const auto distortion = [&](SeamKind kind) {
    options.seams = kind;
    Parameterization map;
    EXPECT_TRUE(Parameterize(can, {options, {}, seams}, {}, &map).ok());
    return map.certificate.distortion->quasi_conformal_mean;
  };
  EXPECT_LT(distortion(SeamKind::kAuto), 1.01);
  EXPECT_GT(distortion(SeamKind::kRigid), 1.3);
}

TEST(Parameterize, UnknownNamesAreRefused) {
  ParameterizeOptions options;
  options.radii_solver = "newtn";
  Parameterization map;
  const Status status = FreeBoundaryMap(GeneratedSurface("bumpy_terrain", 100), options, {}, &map);
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_NE(status.message().find("did you mean 'newton'?"), std::string::npos);
}

TEST(Parameterize, CancellationIsHonoured) {
  const std::atomic<bool> cancelled = true;
  SolveControl control;
  control.cancelled = &cancelled;
  Parameterization map;
  EXPECT_EQ(FreeBoundaryMap(GeneratedSurface("bumpy_terrain", 100), {}, control, &map).code(),
            StatusCode::kCancelled);
}

TEST(Parameterize, IsTheSameForAnyNumberOfThreadsSlow) {
  const Surface surface = GeneratedSurface("spherical_cap", 5 * kParallelBlock);
  const ConeTargets targets = FreeBoundaryTargets(surface.triangulation);
  const auto map = [&](int threads) {
    const ThreadLimit limit(threads);
    Parameterization result;
    EXPECT_TRUE(Parameterize(surface, {{}, targets}, {}, &result).ok());
    return result.uv.value;
  };
  const std::vector<Eigen::Vector2d> of_one = map(1);
  EXPECT_EQ(map(3), of_one);
  EXPECT_GT((of_one[0] - of_one[1]).norm(), 0);
}

TEST(Parameterize, ANeedleWhoseLengthsAreThoseOfNoTriangleHasAMap) {
  const Surface needle = *SurfaceFromTriangles(
      {{0, 0, 0}, {1, 0, 0}, {-2.332905658884213, 7.717260006598265e-08, 0}}, {{0, 1, 2}});
  for (const LayoutMethod layout : {LayoutMethod::kDirections, LayoutMethod::kLeastSquares}) {
    ParameterizeOptions options;
    options.layout = layout;
    const Parameterization map = Flatten(needle, StatusCode::kOk, options);
    ASSERT_EQ(map.uv.value.size(), 3u);
    for (const Eigen::Vector2d& uv : map.uv.value) EXPECT_TRUE(uv.allFinite());
    EXPECT_EQ(map.certificate.layout->flipped_triangles, 0);
  }
}

}  // namespace
}  // namespace cirque

#include "cirque/pipeline/finish_layout.h"

#include <cmath>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cuts/cut_graph.h"
#include "cirque/layout/map_objective.h"
#include "cirque/layout/seams.h"
#include "cirque/layout/stretch_energy.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"
#include "tests/layout/coiled_strip.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

Parameterization MapOf(const Surface& surface, const ParameterizeOptions& options) {
  Parameterization map;
  const Status status = Parameterize(surface, {options}, {}, &map);
  EXPECT_TRUE(status.ok()) << status.message();
  return map;
}

double Distortion(const Parameterization& map) {
  return map.certificate.distortion->quasi_conformal_mean - 1;
}

TEST(EveryMapObjective, LowersTheDistortionWhileConesAndSeamsStay) {
  for (const char* surface_name : {"bumpy_terrain", "blob", "torus", "double_torus"}) {
    const Surface surface = GeneratedSurface(surface_name, 1000);
    const Triangulation& t = surface.triangulation;
    ParameterizeOptions options;
    options.angle_objective = "quadratic";  // which leaves more to do
    options.refine_map = "none";
    const Parameterization plain = MapOf(surface, options);
    for (const std::string& name : MapObjectives().Names()) {
      SCOPED_TRACE(std::string(surface_name) + " " + name);
      options.refine_map = name;
      const Parameterization refined = MapOf(surface, options);
      EXPECT_LT(Distortion(refined), 0.99 * Distortion(plain));
      EXPECT_TRUE(FlippedFaces(t, refined.uv).empty());
      const Certificate& certificate = refined.certificate;
      EXPECT_GE(certificate.map_refinement->map_refinement_steps, 1);
      EXPECT_LT(certificate.map_refinement->map_refinement_after,
                certificate.map_refinement->map_refinement_before);
      EXPECT_EQ(refined.cut.edge, plain.cut.edge);
      // Every seam turns by what it turned, and the cones' angles are what was asked for.
      EXPECT_LT(certificate.seams->seam_gap, 1e-12);
      EXPECT_LT(certificate.seams->seam_rotation_mismatch, 1e-9);
      EXPECT_LT(certificate.seams->cone_rotation_mismatch, 1e-9);
      const std::vector<Index> cones = ConeVertices(BoundaryVertices(t), plain.targets);
      const auto rotations = [&](const Parameterization& map) {
        return MeasureSeams(t, map.cut, cones, map.flat.on_input.angles, map.uv).seams;
      };
      const std::vector<Seam> before = rotations(plain), after = rotations(refined);
      ASSERT_EQ(before.size(), after.size());
      for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_NEAR(std::remainder(before[i].rotation - after[i].rotation, 2 * kPi), 0, 1e-9);
      }
    }
  }
}

TEST(EveryStretchEnergy, LowersItselfWithSeamsKeptOrFree) {
  for (const char* surface_name : {"bumpy_terrain", "blob", "double_torus"}) {
    const Surface surface = GeneratedSurface(surface_name, 1000);
    const Triangulation& t = surface.triangulation;
    for (const SeamKind seams : {SeamKind::kRigid, SeamKind::kFree}) {
      ParameterizeOptions options;
      options.seams = seams;
      options.refine_map = "none";
      const Parameterization plain = MapOf(surface, options);
      for (const std::string& name : StretchEnergies().Names()) {
        SCOPED_TRACE(std::string(surface_name) + " " + name +
                     (seams == SeamKind::kFree ? " free" : ""));
        options.refine_map = name + ":steps=15";
        const Parameterization refined = MapOf(surface, options);
        EXPECT_TRUE(FlippedFaces(t, refined.uv).empty());
        const Certificate& certificate = refined.certificate;
        EXPECT_LT(certificate.map_refinement->map_refinement_after,
                  0.9 * certificate.map_refinement->map_refinement_before);
        EXPECT_LT(certificate.distortion->log_area_ratio_l2,
                  plain.certificate.distortion->log_area_ratio_l2);
        EXPECT_EQ(refined.cut.edge, plain.cut.edge);
        if (seams == SeamKind::kFree || !certificate.seams) continue;
        EXPECT_LT(certificate.seams->seam_gap, 1e-8);
        EXPECT_LT(certificate.seams->seam_rotation_mismatch, 1e-8);
        EXPECT_LT(certificate.seams->cone_rotation_mismatch, 1e-8);
      }
    }
  }
}

TEST(RefineLayout, KeepsAPrescribedBoundary) {
  // A curved sheet to a rectangle.
  const Surface surface = Moved(FlatStrip(12, 8), [](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(x.x(), x.y(), 2 * std::sin(x.x()) * std::cos(0.7 * x.y()));
  });
  const Triangulation& t = surface.triangulation;
  const std::vector<bool> boundary = BoundaryVertices(t);
  ConeTargets targets = FreeBoundaryTargets(t);
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (boundary[v]) targets.lower[v] = targets.upper[v] = kPi;
  }
  for (const Index v : {0, 12, 13 * 8, 13 * 8 + 12}) {
    targets.lower[v] = targets.upper[v] = kPi / 2;
  }
  const auto map_by = [&](const char* refinement) {
    ParameterizeOptions options;
    options.refine_map = refinement;
    Parameterization map;
    const Status status = Parameterize(surface, {options, targets}, {}, &map);
    EXPECT_TRUE(status.ok()) << status.message();
    return map;
  };
  const Parameterization plain = map_by("none");
  ASSERT_TRUE(plain.certificate.distortion.has_value());
  EXPECT_FALSE(plain.certificate.map_refinement.has_value());
  for (const char* refinement : {"mips", "auto:mean=0,share=0"}) {
    SCOPED_TRACE(refinement);
    const Parameterization refined = map_by(refinement);
    EXPECT_LT(Distortion(refined), Distortion(plain));
    EXPECT_TRUE(FlippedFaces(t, refined.uv).empty());
    // Corners stay, the others slide: the boundary encloses the same rectangle, as do its vertices in
    // their order.
    double sides = 0, sides_before = 0;
    for (Index c = 0; c < t.num_halfedges(); ++c) {
      const bool stays = refined.uv.value[c] == plain.uv.value[c];
      EXPECT_TRUE(stays || !boundary[t.vertex[c]] || targets.lower[t.vertex[c]] == kPi);
      if (t.twin[c] != kNone) continue;
      const Index tail = Triangulation::Next(c), tip = Triangulation::Prev(c);
      sides += (refined.uv.value[tip] - refined.uv.value[tail]).norm();
      sides_before += (plain.uv.value[tip] - plain.uv.value[tail]).norm();
    }
    EXPECT_NEAR(sides, sides_before, 1e-9 * sides);
    const Index boundary_vertex = 5;  // inside the lower side
    for (Index c = 0; c < t.num_halfedges(); ++c) {
      EXPECT_TRUE(t.vertex[c] != boundary_vertex || refined.uv.value[c] != plain.uv.value[c]);
    }
  }
}

TEST(RefineLayout, KeepsAnInjectiveImageSoWhereItShall) {
  const CoiledStrip coil;
  const Triangulation& t = coil.strip.triangulation;
  const IntrinsicSurface surface = MeasureSurface(t, coil.lengths);
  const InputChart flat = {surface.angles, coil.lengths, {}};
  const std::vector<Index> no_cones;
  for (const char* refine_map : {"symmetric_dirichlet", "arap", "area", "mips:decrease=0"}) {
    SCOPED_TRACE(refine_map);
    for (const bool injective : {false, true}) {
      PlanarLayout layout{coil.start, ConnectedPatches(t), {}, 0};
      std::optional<MapRefinementSummary> summary;
      const LaidOutSurface of = {surface, flat, coil.none, no_cones, nullptr, injective};
      ASSERT_TRUE(RefineLayout(of, FreeBoundaryTargets(t), refine_map, &layout, &summary).ok());
      EXPECT_EQ(OverlapsItself(t, layout.uv), !injective);
      EXPECT_LE(summary->map_refinement_after, summary->map_refinement_before);
    }
  }
}

TEST(RefineLayout, NeedlesOfRatioAMillionAmongOthersComeBack) {
  // The search must go down to steps of 1 / ratio^2.
  const std::optional<SharedSurface> letters = ReadSharedSurface("cgal-mpi_triang");
  if (!letters) GTEST_SKIP() << "no such mesh here";
  ParameterizeOptions options;
  options.angle_objective = "entropy";
  options.refine_map = "none";
  const Parameterization plain = MapOf(letters->surface, options);
  options.refine_map = "auto";
  const Parameterization refined = MapOf(letters->surface, options);
  EXPECT_GT(plain.certificate.distortion->quasi_conformal_max, 1e4);
  EXPECT_LT(refined.certificate.distortion->quasi_conformal_max, 1e3);
  EXPECT_LT(Distortion(refined), 0.6 * Distortion(plain));
}

TEST(RefineLayout, TheDefaultTellsOfItsPatches) {
  const Parameterization map = MapOf(GeneratedSurface("blob", 1000), {});
  const MapRefinementSummary& summary = *map.certificate.map_refinement;
  EXPECT_TRUE(summary.map_refinement_flagged && summary.map_refinement_patches);
  EXPECT_TRUE(summary.map_refinement_rounds && summary.map_refinement_patch_steps);
  EXPECT_LE(summary.map_refinement_after, summary.map_refinement_before);
  ParameterizeOptions options;
  options.refine_map = "mips";
  EXPECT_FALSE(MapOf(GeneratedSurface("blob", 1000), options)
                   .certificate.map_refinement->map_refinement_patches.has_value());
}

TEST(FreeSeams, OpenTheSurfaceAlongTheCutOfItsCones) {
  for (const char* surface_name : {"blob", "torus", "double_torus"}) {
    SCOPED_TRACE(surface_name);
    const Surface surface = GeneratedSurface(surface_name, 1000);
    ParameterizeOptions options;
    const Parameterization rigid = MapOf(surface, options);
    options.seams = SeamKind::kFree;
    const Parameterization open = MapOf(surface, options);
    EXPECT_EQ(open.cut.edge, rigid.cut.edge);
    double stages = 0;
    for (const char* stage : {"cones", "triangulation", "angles", "radii", "layout", "measures"}) {
      stages += SecondsOf(open.certificate).at(stage);
    }
    EXPECT_LE(stages, *open.certificate.seconds.total);
    EXPECT_EQ(open.certificate.layout->cones, rigid.certificate.layout->cones);
    EXPECT_EQ(open.certificate.layout->cut_length, rigid.certificate.layout->cut_length);
    EXPECT_LT(Distortion(open), Distortion(rigid));
    EXPECT_TRUE(FlippedFaces(surface.triangulation, open.uv).empty());
    // What is given up: the sides of the cut are not congruent any more.
    const std::vector<Index> cones =
        ConeVertices(BoundaryVertices(surface.triangulation), rigid.targets);
    const SeamReport seams =
        MeasureSeams(surface.triangulation, open.cut, cones, rigid.flat.on_input.angles, open.uv);
    EXPECT_GT(seams.max_length_mismatch, 1e-3);
  }
}

TEST(FreeSeams, AreTheSameWhereNothingIsCut) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 500);
  ParameterizeOptions options;
  const Parameterization rigid = MapOf(surface, options);
  options.seams = SeamKind::kFree;
  EXPECT_EQ(MapOf(surface, options).uv.value, rigid.uv.value);
  EXPECT_TRUE(FlippedFaces(surface.triangulation, rigid.uv).empty());
}

TEST(RefineLayout, WrongNamesAndOptionsAreRefusedBeforeTheSolve) {
  const Surface surface = GeneratedSurface("blob", 500);
  const auto refusal = [&](const ParameterizeOptions& options) {
    Parameterization map;
    const Status status = Parameterize(surface, {options}, {}, &map);
    EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
    EXPECT_FALSE(map.certificate.seconds.angles.has_value());
    return status.message();
  };
  ParameterizeOptions options;
  options.refine_map = "mipz";
  EXPECT_THAT(refusal(options), HasSubstr("did you mean 'mips'"));
  options.refine_map = "aut";
  EXPECT_THAT(refusal(options), HasSubstr("did you mean 'auto'"));
  options.refine_map = "auto:flags=1";
  EXPECT_THAT(refusal(options), HasSubstr("unknown auto option 'flags'; did you mean 'flag'"));
  options.refine_map = "none:steps=1";
  EXPECT_THAT(refusal(options), HasSubstr("none takes no options"));
  options.refine_map = "mips:steps=0";
  EXPECT_THAT(refusal(options), HasSubstr("steps = '0' is not an integer in [1, 1e+06]"));
  options.refine_map = "none";
  options.epsilon = 2;
  EXPECT_EQ(refusal(options), "parameterize: epsilon = '2' is not a number in [1e-12, 1] rad");
}

ConeTargets TargetsAt(const std::vector<std::pair<double, double>>& intervals) {
  ConeTargets targets;
  for (const auto& [lower, upper] : intervals) {
    targets.lower.push_back(lower);
    targets.upper.push_back(upper);
  }
  return targets;
}

TEST(CommonRotationOrder, IsThatOfTheConesAngles) {
  const double right = kPi / 2, third = kPi / 3;
  EXPECT_EQ(CommonRotationOrder(TargetsAt({}), {}), 4);
  EXPECT_EQ(CommonRotationOrder(TargetsAt({{right, right}, {5 * right, 5 * right}}), {0, 1}), 4);
  EXPECT_EQ(CommonRotationOrder(TargetsAt({{third, third}, {5 * third, 5 * third}}), {0, 1}), 6);
  EXPECT_EQ(CommonRotationOrder(TargetsAt({{kPi, kPi}}), {0}), 4);  // a multiple of both
  EXPECT_EQ(CommonRotationOrder(TargetsAt({{right, right}, {third, third}}), {0, 1}), 0);
  EXPECT_EQ(CommonRotationOrder(TargetsAt({{right, 2 * right}}), {0}), 0);      // not fixed
  EXPECT_EQ(CommonRotationOrder(TargetsAt({{1, 1}, {right, right}}), {1}), 4);  // 0 is no cone
}

TEST(SnapRotations, MakeTransitionsOfATorusTranslations) {
  const Surface torus = GeneratedSurface("torus", 500);
  const Triangulation& t = torus.triangulation;
  const Parameterization map = MapOf(torus, {});
  EXPECT_EQ(map.certificate.layout->rotation_order, 4);
  const SeamReport seams = MeasureSeams(t, map.cut, {}, map.flat.on_input.angles, map.uv);
  ASSERT_FALSE(seams.seams.empty());
  for (const Seam& seam : seams.seams) {
    EXPECT_NEAR(std::remainder(seam.rotation, kPi / 2), 0, 1e-12);
    // Exactly: the two sides of every opened edge differ by the same translation or quarter turns.
    for (const Index h : seam.halfedges) {
      const Eigen::Vector2d left =
          map.uv.value[Triangulation::Prev(h)] - map.uv.value[Triangulation::Next(h)];
      const Index g = t.twin[h];
      const Eigen::Vector2d right =
          map.uv.value[Triangulation::Next(g)] - map.uv.value[Triangulation::Prev(g)];
      EXPECT_NEAR(left.norm(), right.norm(), 1e-12 * (1 + left.norm()));
    }
  }
  // Once more changes nothing that counts, and another order does not fit every torus.
  CornerUv again = map.uv;
  EXPECT_TRUE(SnapRotations(t, map.cut, {}, map.flat.on_input.angles, 4, &again));
  double moved = 0;
  for (std::size_t h = 0; h < again.value.size(); ++h) {
    moved = std::max(moved, (again.value[h] - map.uv.value[h]).norm());
  }
  EXPECT_LT(moved, 1e-9);
}

TEST(SnapRotations, LeaveTheUvAloneWhereARotationIsNoMultiple) {
  const Surface blob = GeneratedSurface("blob", 300);
  ParameterizeOptions options;
  options.cones = "greedy:cones=4";
  const Parameterization map = MapOf(blob, options);
  EXPECT_EQ(map.certificate.layout->rotation_order, 0);
  const std::vector<Index> cones = ConeVertices(BoundaryVertices(blob.triangulation), map.targets);
  ASSERT_FALSE(cones.empty());
  CornerUv uv = map.uv;
  EXPECT_FALSE(SnapRotations(blob.triangulation, map.cut, cones, map.flat.on_input.angles, 4, &uv));
  EXPECT_EQ(uv.value, map.uv.value);
}

TEST(MeasureDistortion, KnowsTheFiguresOfAnAffineMap) {
  // Twice as wide as before: quasi-conformal distortion 2 everywhere, no area ratio but the mean.
  const Surface strip = FlatStrip(4, 3);
  const Triangulation& t = strip.triangulation;
  CornerUv uv;
  for (const Index v : t.vertex) {
    uv.value.emplace_back(2 * strip.position[v].x(), strip.position[v].y());
  }
  Certificate certificate;
  const Cut none = {std::vector<bool>(t.num_edges(), false)};
  MeasureDistortion(t, MeasureEdgeLengths(strip), none, uv, &certificate);
  EXPECT_EQ(certificate.overlap, "injective");
  EXPECT_NEAR(certificate.distortion->quasi_conformal_mean, 2, 1e-12);
  EXPECT_NEAR(certificate.distortion->quasi_conformal_max, 2, 1e-12);
  EXPECT_NEAR(certificate.distortion->log_area_ratio_l2, 0, 1e-12);
  // Folded over the middle it has flipped triangles, and its boundary says nothing.
  for (Eigen::Vector2d& p : uv.value) p.x() = std::abs(p.x() - 3.5);
  MeasureDistortion(t, MeasureEdgeLengths(strip), none, uv, &certificate);
  EXPECT_EQ(certificate.overlap, "unknown");
}

}  // namespace
}  // namespace cirque

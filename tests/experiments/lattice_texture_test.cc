// What shows a lattice goes on across every seam of a map onto it, told without eyes.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/generators/generators.h"
#include "cirque/io/io.h"
#include "cirque/math/lattice_pattern.h"

#include "experiments/common/map_view/map_payload.h"
#include "experiments/common/map_view/uv_map.h"
#include "tests/common/run_program.h"
#include "tests/common/surfaces.h"
#include "tests/io/glb_file.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

struct Case {
  std::string surface;
  int triangles;
  LatticeKind kind;
};

const std::vector<Case>& Cases() {
  static const std::vector<Case> kCases = {{"torus", 800, LatticeKind::kSquares},
                                           {"torus", 800, LatticeKind::kTriangles},
                                           {"double_torus", 2000, LatticeKind::kSquares},
                                           {"double_torus", 2000, LatticeKind::kTriangles}};
  return kCases;
}

/// Maps the surface of a case onto its lattice; true where that has come out.
bool Map(const Case& of, const TemporaryFolder& folder, const std::string& outputs) {
  const std::string in = folder.Path("in.obj");
  EXPECT_TRUE(WriteMesh(in, *GenerateMesh(of.surface, {of.triangles, 1})).ok());
  const ProgramResult run = RunProgram(
      "circle_patterns --integer_cells=1500 --cones=moving --cone_budget=8 --holonomy=" +
      std::string(of.kind == LatticeKind::kSquares ? "pi/2 " : "pi/3 ") + in + " " + outputs);
  EXPECT_EQ(run.exit_status, 0) << run.output;
  return run.exit_status == 0;
}

/// How much what is shown differs between the two sides of seams, along each of them.
struct Jump {
  double largest = 0, sum = 0;
  int places = 0;

  void Add(double a, double b) {
    largest = std::max(largest, std::abs(a - b));
    sum += std::abs(a - b);
    ++places;
  }
  double mean() const { return sum / places; }
};

constexpr std::array<double, 5> kAlong = {0.03, 0.21, 0.5, 0.77, 0.94};

/// Of the pattern itself; `shift` moves one side of every seam.
Jump JumpOfPattern(const UvMap& map, LatticeKind kind, const Eigen::Vector2d& shift) {
  Jump jump;
  const auto at = [&](Index h, double t) -> Eigen::Vector2d {  // from its tail to its tip
    return (1 - t) * map.uv.value[Triangulation::Next(h)] +
           t * map.uv.value[Triangulation::Prev(h)];
  };
  for (const Index h : map.seams) {
    const Index twin = map.surface.triangulation.twin[h];
    if (twin < h) continue;
    for (const double t : kAlong) {
      jump.Add(PatternDistance(kind, at(h, t) + shift), PatternDistance(kind, at(twin, 1 - t)));
    }
  }
  return jump;
}

TEST(LatticeTexture, ThePatternGoesOnAcrossEverySeam) {
  for (const Case& of : Cases()) {
    SCOPED_TRACE(of.surface + " " + std::to_string(OrderOf(of.kind)));
    const TemporaryFolder folder;
    if (!Map(of, folder, folder.Path("out.obj"))) continue;
    const StatusOr<UvMap> map = ReadUvMap(folder.Path("out.obj"));
    ASSERT_TRUE(map.ok()) << map.status().message();
    EXPECT_GT(map->seams.size(), 20u);
    EXPECT_GT(map->cones.size(), 3u);
    EXPECT_LT(JumpOfPattern(*map, of.kind, {0, 0}).largest, 1e-7);
    EXPECT_LT(JumpOfPattern(*map, of.kind, {1, 0}).largest, 1e-7);
    const Jump planted = JumpOfPattern(*map, of.kind, {0.3, 0});
    EXPECT_GT(planted.largest, 0.1);
    EXPECT_GT(planted.mean(), 0.02);
    // Cones are points of the lattice, where the pattern is darkest.
    for (std::size_t p = 0; p < map->point_vertex.size(); ++p) {
      for (const auto& [vertex, sum] : map->cones) {
        if (map->point_vertex[p] != vertex) continue;
        EXPECT_GT(PatternDistance(of.kind, map->point_uv[p]), 0.25 - 1e-7);
      }
    }
  }
}

/// Of the picture in a .glb, between triangles that have an edge in common.
Jump JumpOfTexture(const GlbFile& glb, const Eigen::Vector2d& shift) {
  const auto& primitive = glb.json["meshes"][0]["primitives"][0];
  const auto x = glb.Accessor<float>(primitive["attributes"]["POSITION"], "VEC3", 3);
  const auto uv = glb.Accessor<float>(primitive["attributes"]["TEXCOORD_0"], "VEC2", 2);
  const auto corner = glb.Accessor<std::uint32_t>(primitive["indices"], "SCALAR", 1);
  const SquarePicture picture(glb.View(glb.json["images"][0]["bufferView"]));
  using Point = std::array<float, 3>;
  const auto point = [&](std::size_t v) { return Point{x[3 * v], x[3 * v + 1], x[3 * v + 2]}; };
  const auto place = [&](std::size_t v) { return Eigen::Vector2d(uv[2 * v], uv[2 * v + 1]); };
  std::map<std::pair<Point, Point>, std::array<std::size_t, 2>> sides;
  for (std::size_t c = 0; c < corner.size(); ++c) {
    const std::size_t next = c % 3 == 2 ? c - 2 : c + 1;
    sides[{point(corner[c]), point(corner[next])}] = {corner[c], corner[next]};
  }
  Jump jump;
  for (const auto& [ends, at] : sides) {
    const auto& other = sides.at({ends.second, ends.first});
    const bool is_seam = at[0] != other[1] || at[1] != other[0];
    if (!is_seam || ends.second < ends.first) continue;
    for (const double t : kAlong) {
      jump.Add(picture.Sample((1 - t) * place(at[0]) + t * place(at[1]) + shift),
               picture.Sample((1 - t) * place(other[1]) + t * place(other[0])));
    }
  }
  return jump;
}

TEST(LatticeTexture, OfAGlbGoesOnAcrossEverySeam) {
  for (const Case& of : Cases()) {
    SCOPED_TRACE(of.surface + " " + std::to_string(OrderOf(of.kind)));
    const TemporaryFolder folder;
    if (!Map(of, folder, folder.Path("out.glb"))) continue;
    const GlbFile glb(folder.Read("out.glb"));
    const Jump jump = JumpOfTexture(glb, {0, 0});
    EXPECT_GT(jump.places, 50);
    // Grey levels, of some 160 between dark and light: pixels lie otherwise on either side of an edge
    // of the pattern, which is one of them wide.
    EXPECT_LT(jump.mean(), 1);
    EXPECT_GT(JumpOfTexture(glb, {0.3, 0}).mean(), 20);
    EXPECT_GE(glb.json["meshes"].size(), 2u) << "cones are marked";
  }
}

TEST(LatticeTexture, AViewHasThePatternAndWhatItsConesAre) {
  const TemporaryFolder folder;
  const Case& of = Cases()[3];
  ASSERT_TRUE(Map(of, folder, folder.Path("out.obj") + " --view=" + folder.Path("a.html")));
  const std::string page = folder.Read("a.html");
  EXPECT_THAT(page, HasSubstr("\"lattice\":{\"order\":6"));
  EXPECT_THAT(page, HasSubstr("<td>triangles; seams and cones off it by at most"));
  EXPECT_THAT(page, HasSubstr("<th>sectors of the pattern, 6 in the plane</th>"));
  UvMap map = *ReadUvMap(folder.Path("out.obj"));
  EXPECT_FALSE(MapPayload(map).contains("lattice"));
  for (const LatticeKind kind : {LatticeKind::kSquares, LatticeKind::kTriangles}) {
    map.lattice = kind;
    const nlohmann::json lattice = MapPayload(map)["lattice"];
    EXPECT_EQ(lattice["order"], OrderOf(kind));
    const std::vector<double> m = lattice["to_periods"];
    const Eigen::Vector2d p = InPeriods(kind, {0.3, 0.8});
    EXPECT_NEAR(m[0] * 0.3 + m[2] * 0.8, p.x(), 1e-15);
    EXPECT_NEAR(m[1] * 0.3 + m[3] * 0.8, p.y(), 1e-15);
  }
}

}  // namespace
}  // namespace cirque

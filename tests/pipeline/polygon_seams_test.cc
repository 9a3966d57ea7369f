// Seams of polygon meshes run along sides of polygons, whatever asks for them.
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "cirque/cones/registry.h"
#include "cirque/cuts/registry.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/parameterize.h"
#include "cirque/verify/map_check.h"

#include "tests/common/surfaces.h"
#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

using Voxel = std::array<int, 3>;

/// The quads around some cubes of side 1, each cut into two by two by two.
PolygonSoup AroundCubes(const std::set<Voxel>& cubes) {
  std::set<Voxel> cells;
  for (const Voxel& c : cubes) {
    for (int k = 0; k < 8; ++k)
      cells.insert({2 * c[0] + k / 4, 2 * c[1] + k / 2 % 2, 2 * c[2] + k % 2});
  }
  std::map<Voxel, Index> number;
  std::vector<Eigen::Vector3d> position;
  std::vector<std::vector<Index>> faces;
  const auto vertex = [&](const Voxel& at) {
    const auto [found, is_new] = number.emplace(at, static_cast<Index>(position.size()));
    if (is_new) position.emplace_back(0.5 * at[0], 0.5 * at[1], 0.5 * at[2]);
    return found->second;
  };
  for (const Voxel& cell : cells) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        Voxel beyond = cell;
        beyond[axis] += side == 1 ? 1 : -1;
        if (cells.contains(beyond)) continue;
        std::vector<Index> face;
        for (const auto& [u, v] :
             {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
          Voxel at = cell;
          at[axis] += side;
          at[(axis + 1) % 3] += u;
          at[(axis + 2) % 3] += v;
          face.push_back(vertex(at));
        }
        if (side == 0) std::reverse(face.begin(), face.end());
        faces.push_back(face);
      }
    }
  }
  return testing::MakeSoup(std::move(position), faces);
}

PolygonSoup OfGenus(int genus) {
  std::set<Voxel> cubes = {{0, 0, 0}};
  if (genus == 0) return AroundCubes(cubes);
  for (int i = 0; i < 2 * genus + 1; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (i % 2 == 0 || j != 1) cubes.insert({i, j, 0});
    }
  }
  return AroundCubes(cubes);
}

/// What every map of the quads must have, whatever its cones.
void ExpectWholePolygons(const PolygonSoup& soup, const ParameterizeRequest& request) {
  const Surface surface = SurfaceOf(soup);
  Parameterization map;
  const Status status = Parameterize(surface, request, {}, &map);
  ASSERT_TRUE(status.ok()) << status.message();
  const std::vector<bool> inside = EdgesInsidePolygons(surface);
  EXPECT_EQ(std::count(inside.begin(), inside.end(), true),
            surface.triangulation.num_faces() - soup.num_polygons());
  for (Index e = 0; e < surface.triangulation.num_edges(); ++e) {
    EXPECT_FALSE(inside[e] && map.cut.edge[e]) << e;
  }
  const PolygonSoup out = AttachUv(soup, surface, map.uv);
  EXPECT_EQ(out.first_corner, soup.first_corner);
  const StatusOr<verify::MapReport> report = verify::VerifyMap(soup, out, {});
  ASSERT_TRUE(report.ok()) << report.status().message();
  EXPECT_TRUE(report->valid()) << report->Verdict();
}

TEST(PolygonSeams, KeepOffDiagonalsWithTheConesOfEveryHeuristic) {
  for (int genus = 0; genus < 3; ++genus) {
    const PolygonSoup soup = OfGenus(genus);
    for (const std::string& name : ConeHeuristics().Names()) {
      if (name == "given" || (name == "none" && genus != 1)) continue;
      SCOPED_TRACE(name + " on genus " + std::to_string(genus));
      ParameterizeRequest request;
      request.options.cones = name;
      ExpectWholePolygons(soup, request);
    }
  }
}

TEST(PolygonSeams, KeepOffDiagonalsWhateverACutCosts) {
  for (const std::string& cost : CutHeuristics().Names()) {
    for (const SeamKind seams : {SeamKind::kRigid, SeamKind::kFree}) {
      ParameterizeRequest request;
      request.options.cut_cost = cost;
      request.options.seams = seams;
      ExpectWholePolygons(OfGenus(0), request);
    }
  }
}

TEST(PolygonSeams, KeepOffDiagonalsBeyondAGivenCut) {
  const PolygonSoup soup = OfGenus(2);
  const Surface surface = SurfaceOf(soup);
  const std::vector<bool> inside = EdgesInsidePolygons(surface);
  ParameterizeRequest request;
  request.cut = Cut{std::vector<bool>(inside.size(), false)};
  request.cut->edge[std::find(inside.begin(), inside.end(), false) - inside.begin()] = true;
  ExpectWholePolygons(soup, request);
}

TEST(PolygonSeams, AKeyholeIsOpenedAlongItsBridge) {
  const PolygonSoup keyhole = testing::MakeSoup(
      {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
      {{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}});
  ExpectWholePolygons(keyhole, {});
}

}  // namespace
}  // namespace cirque

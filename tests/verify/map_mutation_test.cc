// Maps to the plane and the disk with one planted fault each, and the finding that it must be caught
// by; without the fault they are valid.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/verify/fixtures.h"
#include "tests/verify/mutations.h"

namespace cirque::verify {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::string MapVerdict(const Scene& scene) {
  return Judge(scene.in, scene.out, scene.options).Verdict();
}

/// Takes the k-th corner of triangle f another UV than its neighbours have.
Vector2d& OwnUv(PolygonSoup* map, Index f, Index k) {
  map->texture.push_back(map->texture[map->corner_texture[3 * f + k]]);
  map->corner_texture[3 * f + k] = static_cast<Index>(map->texture.size()) - 1;
  return map->texture.back();
}

void TurnUvs(PolygonSoup* map, Index f) {
  const auto corner = map->corner_texture.begin() + 3 * f;
  std::rotate(corner, corner + 1, corner + 3);
}

void Mirror(PolygonSoup* map) {
  for (Vector2d& uv : map->texture) uv.x() = -uv.x();
}

/// A curved sheet of 4 x 4 squares over its shadow, in one piece: 5 x 5 vertices, 32 triangles.
Scene SheetScene() {
  Scene scene;
  scene.in = Sheet(4);
  scene.out = WithVertexUv(scene.in, Flattened(scene.in));
  scene.options.require_injective = true;
  scene.options.seams.max_patches = 1;
  scene.options.seams.max_edges = 0;
  return scene;
}

const std::vector<Fault> kFaultsOfUvs = {
    {"a triangle turned over", "1 flipped triangle (3)",
     [](Scene* s) { std::swap(s->out.corner_texture[9], s->out.corner_texture[10]); }},
    {"a triangle without area", "1 zero-area triangle (10)",
     [](Scene* s) {
       s->out.texture[6] = {2, 1.25};
     }},
    {"two corners on one point", "zero-area triangles",
     [](Scene* s) { s->out.texture[6] = s->out.texture[7]; }},
    {"an inner vertex moved across an edge", "1 flipped triangle (10)",
     [](Scene* s) {
       s->out.texture[6] = {2.2, 1.5};
     }},
    {"an inner vertex moved far away", "flipped triangles",
     [](Scene* s) {
       s->out.texture[12] = {100, 100};
     }},
    {"a boundary vertex moved across its neighbours", "flipped triangle",
     [](Scene* s) {
       s->out.texture[2] = {2, 2.5};
     }},
    {"a corner pushed into another triangle", "flipped triangle (0)",
     [](Scene* s) {
       OwnUv(&s->out, 0, 1) = {0.5, 2.5};
     }},
    {"two vertices exchanged", "flipped triangles",
     [](Scene* s) { std::swap(s->out.texture[6], s->out.texture[18]); }},
    {"the UVs of a triangle turned", "2 patches, 1 allowed", [](Scene* s) { TurnUvs(&s->out, 9); }},
    {"the UVs of all triangles turned", "32 patches, 1 allowed",
     [](Scene* s) {
       for (Index f = 0; f < 32; ++f) TurnUvs(&s->out, f);
     }},
    {"the UVs of two triangles exchanged", "3 patches, 1 allowed",
     [](Scene* s) {
       std::swap_ranges(s->out.corner_texture.begin() + 12, s->out.corner_texture.begin() + 15,
                        s->out.corner_texture.begin() + 60);
     }},
    {"a slit", "1 seam edge, 0 allowed",
     [](Scene* s) {  // the edge from 2 to 7: what lies to the right of it moves a little
       OwnUv(&s->out, 4, 0) = {2.125, 0};
       OwnUv(&s->out, 5, 0) = {2.125, 0};
     }},
    {"one triangle over its neighbour", "patch 0 overlaps patch 1",
     [](Scene* s) {
       for (Index k = 0; k < 3; ++k) OwnUv(&s->out, 20, k) += Vector2d(1, 0);
     }},
    {"a mirror image", "mirrored as a whole", [](Scene* s) { Mirror(&s->out); }},
    {"a mirror image with its faces reversed", "mirrored as a whole",
     [](Scene* s) {
       Mirror(&s->out);
       ReverseFaces(&s->out);
     }},
    {"NaN", "2 triangles with texture coordinates that are not finite (0, 1)",
     [](Scene* s) { s->out.texture[0].y() = kNaN; }},
    {"infinity", "not finite", [](Scene* s) { s->out.texture[0].y() = HUGE_VAL; }},
    {"a corner without UV", "1 triangle without texture coordinates (3)",
     [](Scene* s) { s->out.corner_texture[10] = kNone; }},
    {"no UVs", "32 triangles without texture coordinates",
     [](Scene* s) { s->out.corner_texture.clear(); }}};

TEST(Mutations, UvsOfASheet) {
  ExpectEachIsFound(SheetScene(), MapVerdict, "valid (injective), 1 patch, 0 seam edges",
                    kFaultsOfUvs);
}

void AddFace(std::vector<Index> corners, PolygonSoup* map) {
  map->corner.insert(map->corner.end(), corners.begin(), corners.end());
  map->corner_texture = map->corner;
  map->first_corner.push_back(static_cast<Index>(map->corner.size()));
}

const std::vector<Fault> kFaultsOfMeshes = {
    {"a face missing", "1 triangle of IN missing from OUT (31)",
     [](Scene* s) { RemoveLastFace(&s->out); }},
    {"a face twice", "1 triangle of OUT not in IN",
     [](Scene* s) {
       AddFace({0, 1, 6}, &s->out);
     }},
    {"a face too many", "1 triangle of OUT not in IN (numbers of OUT: 32)",
     [](Scene* s) {
       AddFace({0, 1, 24}, &s->out);
     }},
    {"a face with another corner", "1 triangle of IN missing from OUT (5)",
     [](Scene* s) { s->out.corner[16] = 24; }},
    {"a vertex moved", "1 vertex moved (7)", [](Scene* s) { s->out.position[7].z() += 0.01; }},
    {"a vertex that is not finite", "1 vertex moved (7)",
     [](Scene* s) { s->out.position[7].z() = kNaN; }},
    {"vertices renumbered, but not in the faces", "vertices moved",
     [](Scene* s) {
       std::rotate(s->out.position.begin(), s->out.position.begin() + 1, s->out.position.end());
     }},
    {"two vertices exchanged", "2 vertices moved (6, 18)",
     [](Scene* s) { std::swap(s->out.position[6], s->out.position[18]); }},
    {"the mesh stretched", "vertices moved",
     [](Scene* s) {
       for (Vector3d& p : s->out.position) p.x() *= 1.5;
     }},
    {"a vertex moved that OUT has scaled", "moved",
     [](Scene* s) {
       for (Vector3d& p : s->out.position) p *= 3;
       s->out.position[7].z() += 0.3;
     }},
    {"a vertex moved, with a far one of no face", "1 vertex moved (7)",
     [](Scene* s) {
       s->in.position.emplace_back(1e9, 0, 0);
       s->out.position.emplace_back(1e9, 0, 0);
       s->out.position[7].z() += 0.01;
     }},
    {"another mesh", "IN has 25 vertices and OUT 16",
     [](Scene* s) { s->out = WithVertexUv(Sheet(3), Flattened(Sheet(3))); }}};

TEST(Mutations, MeshesThatAreNotTheInput) {
  ExpectEachIsFound(SheetScene(), MapVerdict, "valid (injective)", kFaultsOfMeshes);
}

/// A cone of angle 5 pi / 3, cut open along the edge (0, 1), and all that holds of it.
Scene ConeScene() {
  Scene scene;
  scene.in = scene.out = Fan(5, kPi / 3);
  scene.options.require_injective = true;
  scene.options.seams = {1, 1, std::vector<VertexPair>{{0, 1}}, true, 6, 1e-9};
  scene.options.targets = DefaultTargets();
  scene.options.targets.at.assign(6, std::nullopt);
  scene.options.targets.at[0] = AngleInterval{5.0 / 3, 5.0 / 3};
  return scene;
}

const std::vector<Fault> kFaultsOfSeams = {
    {"one side of the seam longer", "differ in length by 0.2",
     [](Scene* s) { s->out.texture.back() *= 1.25; }},
    {"one side longer by a millionth", "differ in length by 1e-06",
     [](Scene* s) { s->out.texture.back() *= 1 + 1e-6; }},
    {"the sum of angles off", "1 vertex with a wrong angle sum (0)",
     [](Scene* s) { s->out = Fan(5, kPi / 3 * (1 + 1e-5)); }},
    {"a cone where none should be", "1 vertex with a wrong angle sum (0)",
     [](Scene* s) { s->options.targets.at[0].reset(); }},
    {"the wrong rotation round the cone", "by no multiple of 2 pi / 6",
     [](Scene* s) { s->out = Fan(5, 0.9); }},
    {"the seam at another edge", "1 edge that should be a seam is none: 0-1",
     [](Scene* s) {
       const PolygonSoup turned = s->out;
       for (Index c = 0; c < 15; ++c) s->out.texture[c] = turned.texture[(c + 3) % 15];
     }},
    {"two seams", "1 seam edge that should not be there: 0-3",
     [](Scene* s) {
       for (int c = 6; c < 15; ++c) s->out.texture[c] += Vector2d(-9, 0);
     }},
    {"angles beyond a full turn", "of its boundary by more than 2 pi (0)",
     [](Scene* s) { s->out = Fan(5, 1.5); }}};

TEST(Mutations, SeamsOfACone) {
  ExpectEachIsFound(ConeScene(), MapVerdict, "valid (injective), 1 patch, 1 seam edge",
                    kFaultsOfSeams);
}

/// Six squares in a row, which in the plane may lie on one another, and two triangles in one file.
Scene StripScene() {
  Scene scene;
  scene.in = scene.out = SquareStrip({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}});
  scene.options.require_injective = true;
  return scene;
}

const std::vector<Fault> kOverlaps = {
    {"a strip that comes back", "the boundary overlaps itself",
     [](Scene* s) {
       s->out.texture = SquareStrip({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {-1, 0}}).texture;
       s->in = s->out = SquareStrip({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {-1, 0}});
     }},
    {"a corner of more than a full turn", "by more than 2 pi (2)",
     [](Scene* s) {
       s->in = s->out = SquareStrip({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}});
     }},
    {"a vertex round which triangles turn twice", "turn exactly once round 1 vertex (0)",
     [](Scene* s) { s->in = s->out = Fan(8, kPi / 2); }}};

TEST(Mutations, StripsThatOverlap) {
  ExpectEachIsFound(StripScene(), MapVerdict, "valid (injective)", kOverlaps);
}

Scene TwoPatches() {
  Scene scene;
  scene.in = MakeSoup({{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
                      {{0, 1, 2}, {3, 4, 5}});
  scene.out = WithVertexUv(scene.in, {{0, 0}, {9, 0}, {0, 9}, {20, 0}, {21, 0}, {20, 1}});
  scene.options.require_injective = true;
  return scene;
}

Fault SecondPatchAt(const char* name, const Vector2d& at, double size) {
  return {name, "patch 0 overlaps patch 1", [=](Scene* s) {
            for (Index v = 3; v < 6; ++v) {
              s->out.texture[v] = at + size * (s->out.texture[v] - Vector2d(20, 0));
            }
          }};
}

TEST(Mutations, PatchesThatOverlap) {
  ExpectEachIsFound(TwoPatches(), MapVerdict, "valid (injective), 2 patches",
                    {SecondPatchAt("across the border", {8.5, 0.25}, 1),
                     SecondPatchAt("inside", {2, 2}, 1), SecondPatchAt("in a corner", {0, 0}, 1),
                     SecondPatchAt("upon", {0, 0}, 9), SecondPatchAt("around", {-5, -5}, 40)});
}

/// An L and a square beside it, both polygons.
Scene PolygonScene() {
  Scene scene;
  scene.in.position = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {2, 2, 1}};
  scene.in.corner = {0, 1, 2, 3, 4, 5, 3, 2, 6, 4};
  scene.in.first_corner = {0, 6, 10};
  scene.out = WithVertexUv(scene.in, Flattened(scene.in));
  return scene;
}

void CutUp(const std::vector<Triangle>& triangles, PolygonSoup* map) {
  *map = WithVertexUv(MakeSoup(map->position, triangles), Flattened(*map));
}

const std::vector<Fault> kFaultsOfPolygons = {
    {"a polygon that crosses itself", "1 face whose border crosses or touches itself (0)",
     [](Scene* s) { std::swap(s->out.corner_texture[1], s->out.corner_texture[3]); }},
    {"a corner upon an edge", "1 face whose border crosses or touches itself (0)",
     [](Scene* s) {
       s->out.texture[3] = {1, 0};
     }},
    {"a polygon turned over", "1 flipped face (1)",
     [](Scene* s) { std::swap(s->out.corner_texture[7], s->out.corner_texture[9]); }},
    {"a polygon without area", "1 zero-area face (1)",
     [](Scene* s) {
       for (const Index c : {6, 7, 8, 9}) s->out.texture[s->out.corner[c]].x() = 2;
       s->out.texture[3] = s->out.texture[4] = {1.5, 1};
       s->out.corner_texture[6] = s->out.corner_texture[9] = 2;
     }},
    {"corners in another order", "1 face of IN missing from OUT (1)",
     [](Scene* s) { std::swap(s->out.corner[7], s->out.corner[8]); }},
    {"triangles outside of the polygon", "1 polygon cut by OUT into triangles that lie partly",
     [](Scene* s) {
       CutUp({{0, 1, 2}, {2, 3, 4}, {2, 4, 5}, {0, 2, 5}, {3, 2, 6}, {3, 6, 4}}, &s->out);
     }},
    {"a triangle of a polygon missing", "1 face of IN missing from OUT (0)", [](Scene* s) {
       CutUp({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {3, 2, 6}, {3, 6, 4}}, &s->out);
     }}};

TEST(Mutations, Polygons) {
  Scene scene = PolygonScene();
  ExpectEachIsFound(scene, MapVerdict, "valid (injective), 1 patch, 0 seam edges",
                    kFaultsOfPolygons);
  CutUp({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {3, 2, 6}, {3, 6, 4}}, &scene.out);
  EXPECT_EQ(MapVerdict(scene), "valid (injective), 1 patch, 0 seam edges");
}

/// A wheel of six triangles whose rim is on the unit circle.
Scene DiskScene() {
  Scene scene;
  scene.in = scene.out = Fan(6, kPi / 3);
  scene.options.unit_disk = true;
  scene.options.circle_tolerance = 1e-12;
  return scene;
}

void PutOnRim(const std::vector<double>& angles, PolygonSoup* map) {
  for (std::size_t c = 0; c < map->corner.size(); ++c) {
    if (map->corner[c] == 0) continue;
    const double t = angles[map->corner[c] - 1];
    map->texture[c] = {std::cos(t), std::sin(t)};
  }
}

const std::vector<Fault> kFaultsOfDisks = {
    {"off the circle", "1 vertex of the boundary off the unit circle (2)",
     [](Scene* s) {
       for (std::size_t c = 0; c < s->out.corner.size(); ++c) {
         if (s->out.corner[c] == 2) s->out.texture[c] *= 1.0001;
       }
     }},
    {"out of order", "does not go round the circle once, in order",
     [](Scene* s) {
       PutOnRim({0, 1, 3, 2, 4, 5}, &s->out);
     }},
    {"twice round", "2 turns",
     [](Scene* s) {
       PutOnRim({0, 2.1, 4.2, 6.3, 8.4, 10.5}, &s->out);
     }},
    {"two vertices at one place", "zero-area triangle",
     [](Scene* s) {
       PutOnRim({0, 1, 2, 2, 4, 5}, &s->out);
     }},
    {"cut open", "seams cut the disk",
     [](Scene* s) {
       for (int c = 0; c < 9; ++c) s->out.texture[c] += Vector2d(0, 3);
     }},
    {"no boundary", "the surface is no disk", [](Scene* s) {
       s->in = MakeSoup({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                        {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
       s->out = WithCornerUv(s->in, {{0, 0},
                                     {1, 0},
                                     {0, 1},
                                     {2, 0},
                                     {3, 0},
                                     {2, 1},
                                     {4, 0},
                                     {5, 0},
                                     {4, 1},
                                     {6, 0},
                                     {7, 0},
                                     {6, 1}});
     }}};

TEST(Mutations, Disks) {
  ExpectEachIsFound(DiskScene(), MapVerdict, "valid (injective)", kFaultsOfDisks);
}

}  // namespace
}  // namespace cirque::verify

#include "cirque/verify/set_aside.h"

#include <algorithm>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "cirque/verify/polygon_check.h"

namespace cirque::verify {
namespace {

using Eigen::Vector3d;

constexpr double kNoArea = 1e-12;  ///< of the square of the size

std::vector<Index> DifferentVertices(const PolygonSoup& in, Index f) {
  std::vector<Index> vertices(in.corner.begin() + in.first_corner[f],
                              in.corner.begin() + in.first_corner[f + 1]);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// Whether the points lie on one line: on that through the two farthest from the first and it.
bool AreInLine(const PolygonSoup& in, const std::vector<Index>& vertices) {
  const Vector3d& first = in.position[vertices.front()];
  Vector3d direction = Vector3d::Zero();
  double size = 0;
  for (const Index v : vertices) {
    const double distance = (in.position[v] / 2 - first / 2).stableNorm();
    if (distance <= size) continue;
    size = distance;
    direction = in.position[v] / 2 - first / 2;
  }
  if (!(size > 0)) return true;
  direction /= size;
  return std::all_of(vertices.begin(), vertices.end(), [&](Index v) {
    const Vector3d offset = (in.position[v] / 2 - first / 2) / size;
    return direction.cross(offset).norm() <= kNoArea;
  });
}

using Side = std::pair<Index, Index>;

template <class Visit>
void ForEachSide(const PolygonSoup& in, Index f, const Visit& visit) {
  for (Index c = in.first_corner[f]; c < in.first_corner[f + 1]; ++c) {
    const Index next = c + 1 < in.first_corner[f + 1] ? c + 1 : in.first_corner[f];
    const Side side = std::minmax(in.corner[c], in.corner[next]);
    if (side.first != side.second) visit(side);
  }
}

/// The sides of a face as it passes them, from tail to tip.
std::vector<Side> PassedSides(const PolygonSoup& in, Index f) {
  std::vector<Side> passed;
  for (Index c = in.first_corner[f]; c < in.first_corner[f + 1]; ++c) {
    const Index next = c + 1 < in.first_corner[f + 1] ? c + 1 : in.first_corner[f];
    if (in.corner[c] != in.corner[next]) passed.emplace_back(in.corner[c], in.corner[next]);
  }
  return passed;
}

Side Back(const Side& side) { return {side.second, side.first}; }

/// Whether the face is none that could be cut into triangles: it turns back along a side at once, or
/// passes one twice the same way, or comes twice to a vertex from which no side leads that it passes
/// both ways, as keyholes do: two loops that meet there.
bool IsNoPolygon(const PolygonSoup& in, Index f) {
  std::vector<Side> passed = PassedSides(in, f);
  for (std::size_t i = 0; i < passed.size(); ++i) {
    if (passed[(i + 1) % passed.size()] == Back(passed[i])) return true;
  }
  std::sort(passed.begin(), passed.end());
  for (std::size_t i = 0; i + 1 < passed.size(); ++i) {
    if (passed[i] == passed[i + 1]) return true;
    if (passed[i].first != passed[i + 1].first) continue;
    const bool is_keyhole = std::any_of(passed.begin(), passed.end(), [&](const Side& side) {
      return side.first == passed[i].first &&
             std::binary_search(passed.begin(), passed.end(), Back(side));
    });
    if (!is_keyhole) return true;
  }
  return false;
}

/// The sides of more than two of the faces that are not left out.
std::vector<Side> CrowdedSides(const PolygonSoup& in, const std::vector<bool>& left_out) {
  std::vector<Side> sides, crowded;
  for (Index f = 0; f < in.num_polygons(); ++f) {
    if (!left_out[f]) ForEachSide(in, f, [&](const Side& side) { sides.push_back(side); });
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i + 2 < sides.size(); ++i) {
    const bool is_crowded = sides[i] == sides[i + 2];
    if (is_crowded && (crowded.empty() || crowded.back() != sides[i])) crowded.push_back(sides[i]);
  }
  return crowded;
}

}  // namespace

std::vector<bool> MaySetAside(const PolygonSoup& in) {
  std::vector<bool> aside(in.num_polygons());
  for (Index f = 0; f < in.num_polygons(); ++f) {
    const std::vector<Index> vertices = DifferentVertices(in, f);
    aside[f] = vertices.size() < 3 || AreInLine(in, vertices) || IsNoPolygon(in, f);
    ForEachSide(in, f, [&](const Side& side) {
      if (in.position[side.first] == in.position[side.second]) aside[f] = true;
    });
  }
  const std::vector<Side> crowded = CrowdedSides(in, aside);
  if (crowded.empty()) return aside;
  std::set<std::vector<Index>> known;
  for (Index f = 0; f < in.num_polygons(); ++f) {
    bool is_crowded = false;
    ForEachSide(in, f, [&](const Side& side) {
      is_crowded = is_crowded || std::binary_search(crowded.begin(), crowded.end(), side);
    });
    if (!aside[f] && is_crowded) aside[f] = !known.insert(DifferentVertices(in, f)).second;
  }
  return aside;
}

std::vector<bool> KeepInLine(std::vector<bool> faces, const PolygonSoup& in, const MeshMatch& match,
                             const PolygonSoup& out) {
  std::vector<Point> image;
  for (Index f = 0; f < in.num_polygons(); ++f) {
    if (!faces[f]) continue;
    image.clear();
    const auto cut = match.faces.pieces.find(f);
    const std::vector<Index> whole = {match.faces.out_face[f]};
    for (const Index g : cut != match.faces.pieces.end() ? cut->second : whole) {
      for (Index c = out.first_corner[g]; c < out.first_corner[g + 1]; ++c) {
        image.push_back(out.texture[out.corner_texture[c]]);
      }
    }
    faces[f] = IsOnOneLine(image);
  }
  return faces;
}

}  // namespace cirque::verify

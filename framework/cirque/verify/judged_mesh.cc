#include "cirque/verify/judged_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <Eigen/Geometry>

namespace cirque::verify {
namespace {

using Eigen::Vector3d;

/// The corner of face f of IN, counted from its first, at every corner of face g of OUT.
class Places {
 public:
  Places(const MeshMatch& match, Index f) : match_(match) {
    for (Index k = match.in.NumCorners(f) - 1; k >= 0; --k) by_name_[match.in.Name(f, k)] = k;
  }

  /// Of a piece of the face.
  std::vector<int> OfPiece(Index g) const {
    std::vector<int> places;
    for (Index k = 0; k < match_.out.NumCorners(g); ++k) {
      places.push_back(by_name_.at(match_.out.Name(g, k)));
    }
    return places;
  }

 private:
  const MeshMatch& match_;
  std::map<Index, int> by_name_;
};

/// Of the whole face: names may occur twice, so the corners are compared in turn.
std::vector<int> PlacesInWhole(const MeshMatch& match, Index f, Index g, bool reversed) {
  const Index n = match.in.NumCorners(f);
  std::vector<int> places(n);
  for (Index first = 0; first < n; ++first) {
    bool same = true;
    for (Index k = 0; same && k < n; ++k) {
      places[k] = reversed ? (first + n - k) % n : (first + k) % n;
      same = match.out.Name(g, k) == match.in.Name(f, places[k]);
    }
    if (same) break;
  }
  return places;
}

}  // namespace

std::vector<bool> TurnedFaces(const PolygonSoup& in, const Surface& surface) {
  std::vector<bool> turned(in.num_polygons(), false);
  for (const Index t : surface.turned) turned[surface.mesh.face[t]] = true;
  return turned;
}

namespace {

class Builder {
 public:
  Builder(const PolygonSoup& in, const JudgedFaces& faces, const MeshMatch& match,
          const ImageOf& image_of, const SameImage& same)
      : in_(in), faces_(faces), match_(match), image_of_(image_of), same_(same) {
    reversed_.assign(in.num_polygons(), false);
    for (const Index f : match.faces.reversed) reversed_[f] = true;
    judged_.mesh.num_vertices = static_cast<Index>(in.position.size());
  }

  JudgedMesh Build() {
    for (Index f = 0; f < in_.num_polygons(); ++f) {
      if (faces_.left_out[f]) continue;
      const auto cut = match_.faces.pieces.find(f);
      if (cut == match_.faces.pieces.end()) {
        const Index g = match_.faces.out_face[f];
        AddPart(f, g, PlacesInWhole(match_, f, g, reversed_[f]));
        continue;
      }
      const Places places(match_, f);
      for (const Index g : cut->second) AddPart(f, g, places.OfPiece(g));
    }
    return std::move(judged_);
  }

 private:
  void AddPart(Index f, Index g, const std::vector<int>& places) {
    auto n = static_cast<int>(match_.in.NumCorners(f));
    const bool turned = faces_.turned[f], is_whole = static_cast<int>(places.size()) == n;
    corners_.clear();
    for (std::size_t k = 0; k < places.size(); ++k) {
      corners_.push_back({in_.corner[in_.first_corner[f] + places[k]],
                          match_.out.first_corner[g] + static_cast<Index>(k),
                          turned ? n - 1 - places[k] : places[k]});
    }
    if (reversed_[f] != turned) std::reverse(corners_.begin(), corners_.end());
    if (is_whole) {
      DropRepeatedCorners(same_, &corners_);
      n = static_cast<int>(corners_.size());
      if (n < 3) return Note(f, PolygonShape::kZeroArea);
    }
    const auto [shape, triangles] = image_of_(corners_);
    Note(f, shape);
    AddTriangles(f, n, corners_, triangles, &judged_.mesh);
  }

  void Note(Index f, PolygonShape shape) {
    Orientations& found = judged_.orientations;
    if (shape == PolygonShape::kSimple) {
      ++found.num_upright;
      return;
    }
    std::vector<Index>& faces = shape == PolygonShape::kFlipped    ? found.flipped
                                : shape == PolygonShape::kZeroArea ? found.zero_area
                                                                   : found.folded;
    if (faces.empty() || faces.back() != f) faces.push_back(f);
  }

  const PolygonSoup& in_;
  const JudgedFaces& faces_;
  const MeshMatch& match_;
  const ImageOf& image_of_;
  const SameImage& same_;
  std::vector<bool> reversed_;
  std::vector<FaceCorner> corners_;
  JudgedMesh judged_;
};

}  // namespace

JudgedMesh BuildJudgedMesh(const PolygonSoup& in, const JudgedFaces& faces, const MeshMatch& match,
                           const ImageOf& image_of, const SameImage& same) {
  return Builder(in, faces, match, image_of, same).Build();
}

namespace {

/// The corners of a face about its first one, in units of its size.
std::vector<Vector3d> ScaledCorners(const PolygonSoup& in, Index f) {
  std::vector<Vector3d> corners;
  double size = 0;
  for (Index c = in.first_corner[f]; c < in.first_corner[f + 1]; ++c) {
    corners.push_back(in.position[in.corner[c]] / 2 -
                      in.position[in.corner[in.first_corner[f]]] / 2);
    size = std::max(size, corners.back().cwiseAbs().maxCoeff());
  }
  for (Vector3d& corner : corners) corner /= size > 0 ? size : 1;
  return corners;
}

Vector3d VectorArea(const std::vector<Vector3d>& corners, const std::vector<int>& places) {
  Vector3d area = Vector3d::Zero();
  for (std::size_t k = 0; k < places.size(); ++k) {
    area += 0.5 * corners[places[k]].cross(corners[places[(k + 1) % places.size()]]);
  }
  return area;
}

/// The coordinate axis that is nearest to a direction, pointing its way.
Vector3d NearestAxis(const Vector3d& direction) {
  Eigen::Index k = 0;
  direction.cwiseAbs().maxCoeff(&k);
  return std::copysign(1, direction[k]) * Vector3d::Unit(k);
}

/// Whether the face's border is simple in projection along its vector area.
bool IsSimpleInProjection(const std::vector<Vector3d>& corners, const Vector3d& area) {
  const Vector3d x = area.unitOrthogonal(), y = area.normalized().cross(x);
  std::vector<Point> projected;
  for (const Vector3d& corner : corners) projected.emplace_back(corner.dot(x), corner.dot(y));
  return ShapeOf(projected) == PolygonShape::kSimple;
}

}  // namespace

std::vector<Index> FoldedTriangulations(const PolygonSoup& in, const MeshMatch& match) {
  constexpr double kRounding = 1e-9;
  std::vector<Index> folded;
  for (const auto& [f, pieces] : match.faces.pieces) {
    const std::vector<Vector3d> corners = ScaledCorners(in, f);
    std::vector<int> all(corners.size());
    std::iota(all.begin(), all.end(), 0);
    const Vector3d area = VectorArea(corners, all);
    if (!(area.norm() > kRounding) || !IsSimpleInProjection(corners, area)) continue;
    const bool reversed =
        std::binary_search(match.faces.reversed.begin(), match.faces.reversed.end(), f);
    const Places places(match, f);
    const auto& cut = pieces;
    const auto leaves = [&](const Vector3d& along) {
      return std::any_of(cut.begin(), cut.end(), [&](Index g) {
        const double part = VectorArea(corners, places.OfPiece(g)).dot(along);
        return (reversed ? -part : part) < -kRounding * area.dot(along);
      });
    };
    // A polygon that is far from flat has no one plane: also where it is seen along an axis.
    if (leaves(area) && leaves(NearestAxis(area))) folded.push_back(f);
  }
  return folded;
}

}  // namespace cirque::verify

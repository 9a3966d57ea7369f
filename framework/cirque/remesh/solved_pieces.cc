#include "cirque/remesh/solved_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <glog/logging.h>

namespace cirque {
namespace {

using Plane = Eigen::Vector2d;

Eigen::Vector3d BarycentricIn(const std::array<Plane, 3>& at, const Plane& p) {
  const Eigen::Vector3d areas(Cross(at[1], at[2], p), Cross(at[2], at[0], p),
                              Cross(at[0], at[1], p));
  return areas / Cross(at[0], at[1], at[2]);
}

/// The weights of three barycentric coordinates that make up another.
Eigen::Vector3d Within(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& p) {
  Eigen::Matrix3d columns;
  columns << corners[0], corners[1], corners[2];
  return columns.partialPivLu().solve(p);
}

/// The largest relative difference of two triangles' sides.
double Mismatch(const std::array<Plane, 3>& a, const std::array<Plane, 3>& b) {
  double worst = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = (a[(k + 1) % 3] - a[k]).norm(), other = (b[(k + 1) % 3] - b[k]).norm();
    worst = std::max(worst, std::abs(side - other) / std::max(side, other));
  }
  return worst;
}

}  // namespace

SolvedPieces::SolvedPieces(const Surface& surface, const FlatDomain& solved, const ExactMap& map)
    : surface_(surface),
      solved_(solved),
      map_(map),
      pieces_(SortIntoBuckets(map.face_of_solved, solved.triangulation().num_faces())),
      in_solved_(map.face_of_solved.size()) {
  for (Index f = 0; f < solved.triangulation().num_faces(); ++f) {
    const std::array<Plane, 3> corners = Corners(f);
    for (Index i = pieces_.first[f]; i < pieces_.first[f + 1]; ++i) {
      const Index piece = pieces_.item[i];
      for (std::size_t k = 0; k < 3; ++k) {
        const Index corner = 3 * piece + static_cast<Index>(k);
        in_solved_[piece][k] = BarycentricIn(corners, map.uv[map.corner_uv[corner]]);
      }
    }
  }
}

std::vector<SolvedPieces::PlacedVertex> SolvedPieces::VerticesIn(Index face) const {
  std::vector<PlacedVertex> found;
  for (Index i = pieces_.first[face]; i < pieces_.first[face + 1]; ++i) {
    for (Index c = 3 * pieces_.item[i]; c < 3 * pieces_.item[i] + 3; ++c) {
      const PlacedVertex placed = {map_.corner[c], map_.uv[map_.corner_uv[c]]};
      if (placed.first < solved_.triangulation().num_vertices &&
          std::find(found.begin(), found.end(), placed) == found.end()) {
        found.push_back(placed);
      }
    }
  }
  CHECK_EQ(found.size(), 3U) << "a face of the exact map without its corners";
  if (Cross(found[0].second, found[1].second, found[2].second) < 0) std::swap(found[1], found[2]);
  return found;
}

std::array<Plane, 3> SolvedPieces::Corners(Index face) const {
  const std::vector<PlacedVertex> found = VerticesIn(face);
  const std::array<Plane, 3> metric = {solved_.Corner(3 * face), solved_.Corner(3 * face + 1),
                                       solved_.Corner(3 * face + 2)};
  std::array<Plane, 3> best = {};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t turn = 0; turn < 3; ++turn) {
    std::array<Plane, 3> turned;
    bool is_same = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& [vertex, at] = found[(k + turn) % 3];
      turned[k] = at;
      is_same =
          is_same && vertex == solved_.triangulation().vertex[3 * face + static_cast<Index>(k)];
    }
    // A face may have a vertex twice: then its sides tell the turns apart.
    if (!is_same || Mismatch(turned, metric) >= least) continue;
    least = Mismatch(turned, metric);
    best = turned;
  }
  return best;
}

SolvedPieces::Coordinates SolvedPieces::OnInput(Index piece) const {
  Coordinates on_input;
  for (std::size_t k = 0; k < 3; ++k) {
    const SurfacePoint& point = map_.point[map_.corner[3 * piece + static_cast<Index>(k)]];
    on_input[k] = InFace(surface_.triangulation, point, map_.face_of_input[piece]);
  }
  return on_input;
}

SurfacePoint SolvedPieces::OnSurface(Index face, const Eigen::Vector3d& barycentric) const {
  Index best = kNone;
  double farthest = -std::numeric_limits<double>::infinity();
  Eigen::Vector3d weight(0, 0, 0);
  for (Index i = pieces_.first[face]; i < pieces_.first[face + 1]; ++i) {
    const Eigen::Vector3d here = Within(in_solved_[pieces_.item[i]], barycentric);
    if (!here.allFinite() || !(here.minCoeff() > farthest)) continue;
    farthest = here.minCoeff();
    best = pieces_.item[i];
    weight = here;
  }
  CHECK_NE(best, kNone) << "a face of the exact map without pieces";
  weight = weight.cwiseMax(0);
  const Coordinates on_input = OnInput(best);
  SurfacePoint point{map_.face_of_input[best], Eigen::Vector3d::Zero()};
  for (Eigen::Index k = 0; k < 3; ++k) point.barycentric += weight[k] * on_input[k];
  point.barycentric = point.barycentric.cwiseMax(0);
  point.barycentric /= point.barycentric.sum();
  return point;
}

Eigen::VectorXd SolvedPieces::SurfaceAreas() const {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(solved_.triangulation().num_faces());
  for (Index piece = 0; piece < map_.num_triangles(); ++piece) {
    const Coordinates on_input = OnInput(piece);
    std::array<Eigen::Vector3d, 3> at;
    for (std::size_t k = 0; k < 3; ++k)
      at[k] = PositionOf(surface_, {map_.face_of_input[piece], on_input[k]});
    areas[map_.face_of_solved[piece]] += 0.5 * (at[1] - at[0]).cross(at[2] - at[0]).norm();
  }
  return areas;
}

Eigen::Vector3d PositionOf(const Surface& surface, const SurfacePoint& point) {
  const Index* v = &surface.triangulation.vertex[3 * point.face];
  const Eigen::Vector3d& weight = point.barycentric;
  return weight[0] * surface.position[v[0]] + weight[1] * surface.position[v[1]] +
         weight[2] * surface.position[v[2]];
}

}  // namespace cirque

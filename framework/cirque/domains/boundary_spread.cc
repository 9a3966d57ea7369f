#include "cirque/domains/boundary_spread.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

#include "cirque/layout/linear_layout.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/metrics/mapped_faces.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

constexpr double kShares[] = {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.3, 1};

/// A side of the polygon: its vertices from corner to corner, and for each the share of the side
/// before it, in the flat metric and on the surface.
struct Side {
  std::vector<Index> vertex;
  std::vector<double> flat = {0}, arc = {0};
  double length = 0;  ///< in the flat metric
};

void ToShares(std::vector<double>* along) {
  const double total = along->back();
  for (double& x : *along) x /= total;
}

std::vector<Side> SidesOf(const IntrinsicSurface& disk, const EdgeLengths& flat,
                          const std::vector<Index>& corners) {
  const Triangulation& t = disk.triangulation;
  std::vector<Index> loop = BoundaryLoops(t).front();
  const auto at_first = [&](Index h) { return t.Tail(h) == corners.front(); };
  std::rotate(loop.begin(), std::find_if(loop.begin(), loop.end(), at_first), loop.end());
  std::vector<Side> sides;
  for (const Index h : loop) {
    const bool is_corner = std::find(corners.begin(), corners.end(), t.Tail(h)) != corners.end();
    if (is_corner) sides.push_back({{t.Tail(h)}});
    Side& side = sides.back();
    side.vertex.push_back(t.Tip(h));
    side.flat.push_back(side.flat.back() + flat.value[t.edge[h]]);
    side.arc.push_back(side.arc.back() + disk.lengths.value[t.edge[h]]);
  }
  for (Side& side : sides) {
    side.length = side.flat.back();
    ToShares(&side.flat);
    ToShares(&side.arc);
  }
  return sides;
}

/// Corners of a polygon of equal angles with these sides, in units of the first. The last side is
/// what is left.
std::vector<Complex> CornersOf(const std::vector<Side>& sides) {
  std::vector<Complex> corners = {0};
  for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
    const double turned = 2 * kPi * static_cast<double>(k) / static_cast<double>(sides.size());
    corners.push_back(corners.back() + std::polar(sides[k].length / sides[0].length, turned));
  }
  return corners;
}

void PlaceBoundary(const std::vector<Side>& sides, double share,
                   std::vector<Eigen::Vector2d>* position) {
  const std::vector<Complex> corners = CornersOf(sides);
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const Complex begin = corners[k], end = corners[(k + 1) % corners.size()];
    for (std::size_t i = 0; i + 1 < sides[k].vertex.size(); ++i) {
      const double x = (1 - share) * sides[k].flat[i] + share * sides[k].arc[i];
      const Complex z = begin + x * (end - begin);
      (*position)[sides[k].vertex[i]] = {z.real(), z.imag()};
    }
  }
}

}  // namespace

std::optional<double> LeastDistortingShare(const IntrinsicSurface& surface,
                                           const PlaceWithShare& place) {
  std::optional<double> best;
  double least = std::numeric_limits<double>::infinity();
  for (const double share : kShares) {
    CornerUv uv;
    if (!place(share, &uv)) continue;
    const MappedFaces faces = MeasureFaces(surface.triangulation, surface.lengths, uv);
    const Eigen::ArrayXd quasi_conformal = faces.sigma_max.array() / faces.sigma_min.array();
    const double mean = faces.area.dot(quasi_conformal.log().matrix());
    if (!best || mean < least) best = share;
    least = std::min(least, mean);
  }
  return best;
}

Status SpreadInPolygon(const IntrinsicSurface& disk, const EdgeLengths& flat,
                       const std::vector<Index>& corners, CornerUv* uv) {
  const Triangulation& t = disk.triangulation;
  const std::vector<Side> sides = SidesOf(disk, flat, corners);
  const Eigen::VectorXd weights = PositiveCotangents(t, disk.angles);
  const auto place = [&](double share, CornerUv* placed) {
    std::vector<Eigen::Vector2d> position(t.num_vertices, Eigen::Vector2d::Zero());
    PlaceBoundary(sides, share, &position);
    if (!EmbedConvexly(t, weights, disk.boundary, &position).ok()) return false;
    placed->value.clear();
    for (const Index v : t.vertex) placed->value.push_back(position[v]);
    return FlippedFaces(t, *placed).empty();
  };
  const std::optional<double> share = LeastDistortingShare(disk, place);
  if (share && place(*share, uv)) return Status();
  return Status(StatusCode::kUnrepresentable,
                "doubles do not tell the polygon's vertices apart, however its boundary is spread");
}

}  // namespace cirque

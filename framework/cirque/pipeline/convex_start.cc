#include "cirque/pipeline/convex_start.h"

#include <cmath>
#include <utility>
#include <vector>

#include "cirque/core/triangulation.h"
#include "cirque/layout/linear_layout.h"
#include "cirque/metrics/injectivity.h"

namespace cirque {
namespace {

/// The boundary on the circle about 0 of the surface's area.
std::vector<Eigen::Vector2d> BoundaryOnCircle(const IntrinsicSurface& disk) {
  const Triangulation& t = disk.triangulation;
  const std::vector<Index> loop = BoundaryLoops(t).front();
  double total = 0, run = 0;
  for (const Index h : loop) total += disk.lengths.value[t.edge[h]];
  const double radius = std::sqrt(SurfaceArea(disk) / kPi);
  std::vector<Eigen::Vector2d> position(t.num_vertices, Eigen::Vector2d::Zero());
  for (const Index h : loop) {
    const double angle = 2 * kPi * run / total;
    position[t.Tail(h)] = radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    run += disk.lengths.value[t.edge[h]];
  }
  return position;
}

}  // namespace

std::optional<CornerUv> EmbedInDisk(const IntrinsicSurface& disk) {
  const Triangulation& t = disk.triangulation;
  // Equal weights first: they spread vertices by their neighbours, however long the limb between is.
  const Eigen::VectorXd equal = Eigen::VectorXd::Ones(t.num_edges());
  for (const Eigen::VectorXd& weights : {equal, PositiveCotangents(t, disk.angles)}) {
    std::vector<Eigen::Vector2d> position = BoundaryOnCircle(disk);
    if (!EmbedConvexly(t, weights, disk.boundary, &position).ok()) continue;
    CornerUv uv;
    for (const Index v : t.vertex) uv.value.push_back(position[v]);
    if (FlippedFaces(t, uv).empty()) return uv;
  }
  return std::nullopt;
}

}  // namespace cirque

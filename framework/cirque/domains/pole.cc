#include "cirque/domains/pole.h"

#include <algorithm>
#include <cmath>

#include "cirque/intrinsic/corner_angles.h"
#include "cirque/mesh/farthest_vertices.h"

namespace cirque {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kShortList = 64;
/// Vertices at the pole's own place are taken to be this share of the farthest distance away.
constexpr double kNearest = 1e-9;

/// Distances of all vertices from one of them, the farthest being 1.
std::vector<double> RelativeDistances(const Surface& surface, Index pole) {
  std::vector<double> distance;
  double farthest = 0;
  for (const Vector3d& x : surface.position) {
    distance.push_back((x - surface.position[pole]).stableNorm());
    farthest = std::max(farthest, distance.back());
  }
  for (double& r : distance) r = std::max(r / farthest, kNearest);
  return distance;
}

/// Per vertex the area of its star times the star's smallest angle; 0 where the star is no disk.
std::vector<double> StarQualities(const IntrinsicTriangulation& intrinsic) {
  const Triangulation& t = intrinsic.triangulation;
  const CornerAngles angles = MeasureCornerAngles(t, intrinsic.lengths);
  std::vector<double> area(t.num_vertices, 0), smallest(t.num_vertices, kPi);
  std::vector<Index> corner(t.num_vertices);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index v = t.vertex[h], first = h - h % 3;
    corner[v] = h;
    area[v] += intrinsic.lengths.value[t.edge[Triangulation::Next(h)]] *
               intrinsic.lengths.value[t.edge[Triangulation::Prev(h)]] * std::sin(angles.value[h]);
    smallest[v] = std::min(smallest[v], angles.value.segment<3>(first).minCoeff());
  }
  std::vector<double> quality(t.num_vertices);
  for (Index v = 0; v < t.num_vertices; ++v) {
    quality[v] = HasDiskStar(t, corner[v]) ? area[v] * smallest[v] : 0;
  }
  return quality;
}

double InversionCost(const Surface& surface, const IntrinsicTriangulation& intrinsic, Index pole) {
  const Triangulation& t = intrinsic.triangulation;
  const std::vector<double> distance = RelativeDistances(surface, pole);
  double cost = 0;
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index a = t.Tail(t.edge_halfedge[e]), b = t.Tip(t.edge_halfedge[e]);
    if (a == pole || b == pole) continue;
    const double length = intrinsic.lengths.value[e];
    cost += length * length / (distance[a] * distance[b]);
  }
  return cost;
}

}  // namespace

std::vector<Index> PoleCandidates(const Surface& surface, const IntrinsicTriangulation& intrinsic,
                                  Index count) {
  const std::vector<double> quality = StarQualities(intrinsic);
  std::vector<Index> candidates;
  for (Index v = 0; v < static_cast<Index>(quality.size()); ++v) {
    if (quality[v] > 0) candidates.push_back(v);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](Index a, Index b) { return quality[a] > quality[b]; });
  if (candidates.size() > kShortList) candidates.resize(kShortList);
  if (candidates.empty()) return candidates;
  std::vector<double> cost(quality.size());
  for (const Index v : candidates) cost[v] = InversionCost(surface, intrinsic, v);
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](Index a, Index b) { return cost[a] < cost[b]; });
  return FarthestVertices(intrinsic.triangulation, intrinsic.lengths, candidates,
                          std::min(count, static_cast<Index>(candidates.size())));
}

EdgeLengths InvertedLengths(const Surface& surface, const Triangulation& closed,
                            const EdgeLengths& lengths, const PuncturedSurface& punctured) {
  const std::vector<double> distance = RelativeDistances(surface, punctured.pole);
  const Triangulation& t = punctured.triangulation;
  EdgeLengths inverted = LengthsOf(punctured, closed, lengths);
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    inverted.value[e] /=
        distance[punctured.vertex[t.Tail(h)]] * distance[punctured.vertex[t.Tip(h)]];
  }
  return inverted;
}

}  // namespace cirque

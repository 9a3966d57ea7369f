#include "cirque/remesh/curvature_density.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include "cirque/core/option.h"
#include "cirque/core/text.h"
#include "cirque/linear/registry.h"
#include "cirque/linear/sparse_cholesky.h"

namespace cirque {
namespace {

constexpr char kCurvature[] = "curvature";
constexpr double kNoCurvature = 1e-9;  ///< times the inverse root of the area

Eigen::Vector3d NormalOf(const Surface& surface, Index face) {
  const Index* v = &surface.triangulation.vertex[3 * face];
  const Eigen::Vector3d& a = surface.position[v[0]];
  return (surface.position[v[1]] - a).cross(surface.position[v[2]] - a);  // twice the area
}

/// V: a third of the area of the triangles at each vertex.
Eigen::VectorXd VertexAreas(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(t.num_vertices);
  for (Index f = 0; f < t.num_faces(); ++f) {
    const double third = NormalOf(surface, f).norm() / 6;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) areas[t.vertex[h]] += third;
  }
  return areas;
}

/// V: the norm of the curvature tensor, times the area that it is of: half of every edge's length times its
/// dihedral angle belongs to either end.
Eigen::VectorXd CurvatureOverAreas(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  std::vector<Eigen::Matrix3d> tensor(t.num_vertices, Eigen::Matrix3d::Zero());
  for (const Index h : t.edge_halfedge) {
    if (t.twin[h] == kNone) continue;
    const Eigen::Vector3d edge = surface.position[t.Tip(h)] - surface.position[t.Tail(h)];
    const Eigen::Vector3d left = NormalOf(surface, Triangulation::Face(h)),
                          right = NormalOf(surface, Triangulation::Face(t.twin[h]));
    const double length = edge.norm();
    if (!(length > 0)) continue;
    const double angle = std::atan2(edge.dot(right.cross(left)) / length, left.dot(right));
    const Eigen::Matrix3d part = angle / (2 * length) * edge * edge.transpose();
    tensor[t.Tail(h)] += part;
    tensor[t.Tip(h)] += part;
  }
  Eigen::VectorXd norms(t.num_vertices);
  for (Index v = 0; v < t.num_vertices; ++v) norms[v] = tensor[v].norm();
  return norms;
}

/// The lower triangle of areas + time * Laplacian (cotangents; those of needles are bounded).
SparseMatrix HeatMatrix(const Surface& surface, const Eigen::VectorXd& areas, double time) {
  constexpr double kMostCotangent = 1e3, kLeastWeight = 0;
  const Triangulation& t = surface.triangulation;
  std::vector<Eigen::Triplet<double>> entries;
  for (Index v = 0; v < t.num_vertices; ++v) entries.emplace_back(v, v, areas[v]);
  std::vector<double> weight(t.num_edges(), 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Eigen::Vector3d& apex = surface.position[t.vertex[h]];
    const Eigen::Vector3d a = surface.position[t.Tail(h)] - apex,
                          b = surface.position[t.Tip(h)] - apex;
    const double twice_area = a.cross(b).norm();
    const double cotangent = twice_area > 0 ? a.dot(b) / twice_area : kMostCotangent;
    weight[t.edge[h]] += std::clamp(cotangent, -kMostCotangent, kMostCotangent) / 2;
  }
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index a = t.Tail(t.edge_halfedge[e]), b = t.Tip(t.edge_halfedge[e]);
    const double w = time * std::max(weight[e], kLeastWeight);  // so that nothing falls below 0
    if (a == b || w == 0) continue;
    entries.emplace_back(a, a, w);
    entries.emplace_back(b, b, w);
    entries.emplace_back(std::max(a, b), std::min(a, b), -w);
  }
  SparseMatrix lower(t.num_vertices, t.num_vertices);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

}  // namespace

const OptionTable<CurvatureSizing>& CurvatureSizingTable() {
  using S = CurvatureSizing;
  static const OptionTable<S> kTable(
      kCurvature,
      {Option<S>("strength", &S::strength,
                 "edges are as long as the radius of curvature to this power")
           .Between(0, 4),
       Option<S>("ratio", &S::ratio, "of the longest edges to the shortest").Between(1, 1000),
       Option<S>("smoothing", &S::smoothing,
                 "the length that curvature is smoothed over, as a part of the root of the area")
           .Between(0, 1)});
  return kTable;
}

Eigen::VectorXd DensityByCurvature(const Surface& surface, const CurvatureSizing& sizing) {
  const Eigen::VectorXd areas = VertexAreas(surface);
  const double area = areas.sum();
  const Eigen::VectorXd none = Eigen::VectorXd::Ones(areas.size());
  if (!(area > 0)) return none;
  // A vertex without area shall not make the matrix singular.
  const Eigen::VectorXd mass = areas.array() + 1e-12 * area / static_cast<double>(areas.size());
  const auto cholesky = MakeCholesky();
  if (!cholesky->Factorize(HeatMatrix(surface, mass, sizing.smoothing * sizing.smoothing * area))) {
    return none;
  }
  const Eigen::VectorXd curvature = cholesky->Solve(CurvatureOverAreas(surface));
  const double mean = curvature.dot(areas) / area, least = kNoCurvature / std::sqrt(area);
  if (!(mean > least)) return none;
  const double most = std::log(sizing.ratio) / 2;
  return curvature.unaryExpr([&](double k) {
    const double log_length = -sizing.strength * std::log(std::max(k, least) / mean);
    return std::exp(-2 * std::clamp(log_length, -most, most));
  });
}

bool NamesCurvatureSizing(const std::string& text) {
  return text.substr(0, text.find(':')) == kCurvature;
}

StatusOr<CurvatureSizing> ParseCurvatureSizing(const std::string& text) {
  const StatusOr<NameWithOptions> named = ParseNameWithOptions(text);
  if (!named.ok()) return named.status();
  CurvatureSizing sizing;
  const Status status = CurvatureSizingTable().Set(named->options, &sizing);
  return status.ok() ? StatusOr<CurvatureSizing>(sizing) : status;
}

}  // namespace cirque

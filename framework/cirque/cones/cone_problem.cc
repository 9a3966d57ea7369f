#include "cirque/cones/cone_problem.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glog/logging.h>

#include "cirque/cones/linear_model.h"
#include "cirque/energy/dual_laplacian.h"
#include "cirque/linear/registry.h"

namespace cirque {
namespace {

Eigen::VectorXd Curvatures(const Triangulation& t, const CornerAngles& angles,
                           const std::vector<bool>& boundary) {
  Eigen::VectorXd curvature = Eigen::VectorXd::Constant(t.num_vertices, 2 * kPi);
  for (Index h = 0; h < t.num_halfedges(); ++h) curvature[t.vertex[h]] -= angles.value[h];
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (boundary[v]) curvature[v] = 0;
  }
  return curvature;
}

ConeSource Complete(ConeSource source, const IntrinsicSurface& surface) {
  if (!source.surface) source.surface = &surface;
  const Index num_vertices = surface.triangulation.num_vertices;
  CHECK_EQ(source.surface->triangulation.num_vertices, num_vertices);
  if (source.file.of_vertex.empty()) source.file = VerticesInOrder(num_vertices);
  return source;
}

std::vector<Index> CommonCorners(std::vector<Index> corners, const std::vector<Index>& others) {
  for (std::size_t v = 0; v < corners.size(); ++v) corners[v] = std::min(corners[v], others[v]);
  return corners;
}

}  // namespace

ConeProblem::ConeProblem(IntrinsicSurface surface, ConeSource source)
    : surface_(std::move(surface)),
      source_(Complete(std::move(source), surface_)),
      closed_(BoundaryLoops(triangulation()).empty()),
      total_curvature_(2 * kPi * EulerCharacteristic(triangulation())),
      corners_(CommonCorners(surface_.corners, source_.surface->corners)),
      number_(triangulation().num_vertices, kNone) {
  const Triangulation& t = triangulation();
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (surface_.boundary[v]) continue;
    number_[v] = static_cast<Index>(candidates_.size());
    candidates_.push_back(v);
  }
  curvature_ = Curvatures(t, surface_.angles, surface_.boundary);
  area_ = VertexAreas(surface_);
}

ConeProblem::~ConeProblem() = default;

double ConeProblem::LeastCurvature(Index v) const {
  const double corners = corners_[v];
  return 2 * kPi - kPi * std::min(corners - 0.5, 0.6 * corners);
}

SparseMatrix ConeProblem::LowerLaplacian() const {
  const Triangulation& t = triangulation();
  const auto num_unknowns = static_cast<int>(candidates_.size());
  // The boundary is one more node, whose row is dropped: u = 0 there.
  LaplacianAssembler assembler(num_unknowns + 1, t.num_edges());
  const Eigen::VectorXd weight = CotangentWeights(surface_);
  const auto node = [&](Index v) { return number_[v] == kNone ? num_unknowns : number_[v]; };
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    assembler.Add(node(t.Tail(h)), node(t.Tip(h)), weight[e]);
  }
  SparseMatrix lower;
  assembler.Assemble(&lower);
  return lower.topLeftCorner(num_unknowns, num_unknowns);
}

SparseMatrix ConeProblem::Laplacian() const {
  const SparseMatrix lower = LowerLaplacian();
  return lower.selfadjointView<Eigen::Lower>();
}

Eigen::VectorXd ConeProblem::Solve(const Eigen::VectorXd& b) const {
  const auto num_unknowns = static_cast<Index>(candidates_.size());
  Eigen::VectorXd u = Eigen::VectorXd::Zero(triangulation().num_vertices);
  if (num_unknowns == 0) return u;
  if (!factor_) {
    SparseMatrix lower = LowerLaplacian();
    // The total of a compatible right side is 0, and u_0 then, too, whatever is added here.
    if (closed_) lower.coeffRef(0, 0) += lower.coeff(0, 0);
    factor_ = MakeCholesky();
    CHECK(factor_->Factorize(lower)) << "the Laplacian is not positive definite";
  }
  const double total = closed_ ? b.sum() : 0;
  Eigen::VectorXd right(num_unknowns);
  for (Index i = 0; i < num_unknowns; ++i) {
    right[i] = b[candidates_[i]] - total * area_[candidates_[i]];
  }
  const Eigen::VectorXd solution = factor_->Solve(right);
  for (Index i = 0; i < num_unknowns; ++i) u[candidates_[i]] = solution[i];
  if (closed_) u.array() -= area_.dot(u);
  return u;
}

double AreaNorm(const ConeProblem& problem, const Eigen::VectorXd& u) {
  return std::sqrt(problem.area().dot(u.cwiseAbs2()));
}

}  // namespace cirque

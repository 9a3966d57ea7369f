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

constexpr std::size_t kKeptNumbers = 4'000'000;  ///< of responses

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

void ConeProblem::MakeFactor() const {
  SparseMatrix lower = LowerLaplacian();
  // The total of a compatible right side is 0, and u_0 then, too, whatever is added here.
  if (closed_) lower.coeffRef(0, 0) += lower.coeff(0, 0);
  factor_ = MakeCholesky();
  CHECK(factor_->Factorize(lower)) << "the Laplacian is not positive definite";
  if (closed_) factor_->Solve(area_(candidates_), &of_area_);
}

/// u of the factor's answer to a right side of this total: what is taken from that for it to be compatible
/// is taken from the answer, for a right side of few entries takes half the time.
Eigen::VectorXd ConeProblem::AtVertices(const Eigen::VectorXd& solution, double total) const {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(triangulation().num_vertices);
  u(candidates_) = solution;
  if (!closed_) return u;
  u(candidates_) -= total * of_area_;
  u.array() -= area_.dot(u);
  return u;
}

Eigen::VectorXd ConeProblem::Solve(const Eigen::VectorXd& b) const {
  if (candidates_.empty()) return Eigen::VectorXd::Zero(triangulation().num_vertices);
  if (!factor_) MakeFactor();
  return AtVertices(factor_->Solve(b(candidates_)), b.sum());
}

const Eigen::VectorXd& ConeProblem::LogScaleWithoutCones() const {
  if (without_cones_.size() == 0) without_cones_ = Solve(-curvature_);
  return without_cones_;
}

std::vector<ConeProblem::Response> ConeProblem::SolveForUnits(
    const std::vector<Index>& vertices) const {
  if (vertices.empty()) return {};
  if (!factor_) MakeFactor();
  const auto count = static_cast<Eigen::Index>(vertices.size());
  Eigen::MatrixXd units =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(candidates_.size()), count);
  for (Eigen::Index i = 0; i < count; ++i) units(number_[vertices[i]], i) = 1;
  Eigen::MatrixXd solutions;
  factor_->SolveTogether(units, &solutions);
  std::vector<Response> responses;
  for (Eigen::Index i = 0; i < count; ++i) {
    responses.push_back(std::make_shared<const Eigen::VectorXd>(AtVertices(solutions.col(i), 1)));
  }
  return responses;
}

std::vector<ConeProblem::Response> ConeProblem::Responses(
    const std::vector<Index>& vertices) const {
  std::vector<Index> missing;
  for (const Index v : vertices) {
    CHECK(IsCandidate(v)) << v;
    if (!kept_responses_.contains(v)) missing.push_back(v);
  }
  const std::vector<Response> solved = SolveForUnits(missing);
  const std::size_t most = kKeptNumbers / triangulation().num_vertices;
  std::vector<Response> responses;
  auto next = solved.begin();
  for (const Index v : vertices) {
    const auto kept = kept_responses_.find(v);
    responses.push_back(kept == kept_responses_.end() ? *next++ : kept->second);
  }
  for (std::size_t i = 0; i < missing.size() && kept_responses_.size() < most; ++i) {
    kept_responses_.emplace(missing[i], solved[i]);
  }
  return responses;
}

double AreaNorm(const ConeProblem& problem, const Eigen::VectorXd& u) {
  return std::sqrt(problem.area().dot(u.cwiseAbs2()));
}

}  // namespace cirque

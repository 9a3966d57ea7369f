#include "cirque/cones/boundary_problem.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/cones/linear_model.h"
#include "cirque/energy/dual_laplacian.h"
#include "cirque/linear/registry.h"
#include "cirque/math/compensated_sum.h"

namespace cirque {
namespace {

constexpr double kLeastAngle = 0.2 * kPi, kGreatestAngle = 1.75 * kPi;
constexpr double kShare = 0.8;  ///< of what there is, of what the corners can reach
constexpr int kMostShifts = 200;
constexpr double kRounding = 1e-11;  ///< [rad]: of a sum of angles

SparseMatrix WholeLaplacian(const IntrinsicSurface& surface) {
  const Triangulation& t = surface.triangulation;
  LaplacianAssembler assembler(t.num_vertices, t.num_edges());
  const Eigen::VectorXd weight = CotangentWeights(surface);
  for (Index e = 0; e < t.num_edges(); ++e) {
    assembler.Add(t.Tail(t.edge_halfedge[e]), t.Tip(t.edge_halfedge[e]), weight[e]);
  }
  SparseMatrix lower;
  assembler.Assemble(&lower);
  return lower.selfadjointView<Eigen::Lower>();
}

double Middle(const ConeTargets& targets, Index v) {
  return 0.5 * (targets.lower[v] + targets.upper[v]);
}

}  // namespace

BoundaryProblem::BoundaryProblem(IntrinsicSurface surface, const IntrinsicSurface& input,
                                 const ConeTargets& targets, FileVertices file)
    : surface_(std::move(surface)),
      input_(input),
      file_(std::move(file)),
      laplacian_(WholeLaplacian(surface_)),
      area_(VertexAreas(surface_)) {
  const Triangulation& t = surface_.triangulation;
  if (file_.of_vertex.empty()) file_ = VerticesInOrder(t.num_vertices);
  const std::vector<double> sum = VertexAngleSums(t, surface_.angles);
  is_open_ = surface_.boundary;
  curvature_.resize(t.num_vertices);
  prescribed_ = Eigen::VectorXd::Zero(t.num_vertices);
  CompensatedSum total;
  total += kPi * t.num_faces();
  for (Index v = 0; v < t.num_vertices; ++v) {
    curvature_[v] = (surface_.boundary[v] ? kPi : 2 * kPi) - sum[v];
    if (surface_.boundary[v]) {
      boundary_.push_back(v);
    } else {
      prescribed_[v] = 2 * kPi - Middle(targets, v);
      total -= Middle(targets, v);
    }
  }
  CHECK(!boundary_.empty()) << "a closed surface has no boundary that could turn";
  total_ = total.Value();
  Number();
}

BoundaryProblem::~BoundaryProblem() = default;

BoundaryProblem::Bounds BoundaryProblem::BoundsOf(Index v) const {
  const auto corners = static_cast<double>(std::min(surface_.corners[v], input_.corners[v]));
  const double now = kPi - curvature_[v];
  const double upper = std::min(kGreatestAngle, kShare * kPi * corners);
  return {std::min({kLeastAngle, kShare * now, upper}), upper};
}

SparseCholesky& BoundaryProblem::Factor() const {
  if (factor_) return *factor_;
  SparseMatrix lower(static_cast<Index>(inside_.size()), static_cast<Index>(inside_.size()));
  std::vector<Eigen::Triplet<double, int>> entries;
  entries.reserve(laplacian_.nonZeros());
  for (const Index v : inside_) {
    for (SparseMatrix::InnerIterator it(laplacian_, v); it; ++it) {
      const Index row = number_[it.row()];
      if (row != kNone && row >= number_[v]) entries.emplace_back(row, number_[v], it.value());
    }
  }
  lower.setFromTriplets(entries.begin(), entries.end());
  factor_ = MakeCholesky();
  CHECK(factor_->Factorize(lower)) << "the Laplacian is not positive definite";
  return *factor_;
}

Eigen::VectorXd BoundaryProblem::SolveInside(const Eigen::VectorXd& right_side) const {
  Eigen::VectorXd whole = Eigen::VectorXd::Zero(right_side.size());
  if (inside_.empty()) return whole;
  const Eigen::VectorXd solution = Factor().Solve(right_side(inside_));
  whole(inside_) = solution;
  return whole;
}

Eigen::VectorXd BoundaryProblem::Harmonic(const Eigen::VectorXd& b) const {
  Eigen::VectorXd open = Eigen::VectorXd::Zero(curvature_.size());
  for (const Index v : boundary_) {
    if (is_open_[v]) open[v] = b[v];
  }
  const Eigen::VectorXd flow = laplacian_ * open;
  return open - SolveInside(flow);
}

Eigen::VectorXd BoundaryProblem::HarmonicAdjoint(const Eigen::VectorXd& w) const {
  const Eigen::VectorXd flow = laplacian_ * SolveInside(w);
  Eigen::VectorXd adjoint = Eigen::VectorXd::Zero(w.size());
  for (const Index v : boundary_) {
    if (is_open_[v]) adjoint[v] = w[v] - flow[v];
  }
  return adjoint;
}

Eigen::VectorXd BoundaryProblem::LogScale(const Eigen::VectorXd& b) const {
  return SolveInside(prescribed_ - curvature_) + Harmonic(b);
}

Eigen::VectorXd BoundaryProblem::AngleSums(const Eigen::VectorXd& u) const {
  const Eigen::VectorXd turned = curvature_ + laplacian_ * u;
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(u.size());
  for (const Index v : boundary_) sums[v] = kPi - (is_open_[v] ? turned[v] : prescribed_[v]);
  return sums;
}

bool BoundaryProblem::SettleBeyondBounds(const Eigen::VectorXd& angle_sums) {
  auto open = std::count_if(boundary_.begin(), boundary_.end(),
                            [&](Index v) { return static_cast<bool>(is_open_[v]); });
  bool settled = false;
  for (const Index v : boundary_) {
    const auto [lower, upper] = BoundsOf(v);
    if (!is_open_[v] || open == 1 || (angle_sums[v] >= lower && angle_sums[v] <= upper)) continue;
    is_open_[v] = false;
    prescribed_[v] = kPi - std::clamp(angle_sums[v], lower, upper);
    settled = true;
    --open;
  }
  if (settled) Number();
  return settled;
}

void BoundaryProblem::Number() {
  inside_.clear();
  number_.assign(is_open_.size(), kNone);
  for (Index v = 0; v < surface_.triangulation.num_vertices; ++v) {
    if (is_open_[v]) continue;
    number_[v] = static_cast<Index>(inside_.size());
    inside_.push_back(v);
  }
  factor_.reset();
}

double BoundaryProblem::Missing(const Eigen::VectorXd& angle_sums) const {
  CompensatedSum missing;
  missing += total_;
  for (const Index v : boundary_) missing -= angle_sums[v];
  return missing.Value();
}

StatusOr<Eigen::VectorXd> BoundaryProblem::FitToGaussBonnet(
    const Eigen::VectorXd& angle_sums) const {
  Eigen::VectorXd fitted = angle_sums;
  for (int shift = 0; shift < kMostShifts; ++shift) {
    for (const Index v : boundary_) {
      const auto [lower, upper] = BoundsOf(v);
      fitted[v] = std::clamp(fitted[v], lower, upper);
    }
    const double rest = Missing(fitted);
    std::vector<Index> movable;
    for (const Index v : boundary_) {
      const auto [lower, upper] = BoundsOf(v);
      if (rest > 0 ? fitted[v] < upper : fitted[v] > lower) movable.push_back(v);
    }
    if (std::abs(rest) > kRounding && movable.empty()) break;
    if (std::abs(rest) <= kRounding) {  // too little to be spread: digits of one angle
      if (!movable.empty()) fitted[movable.front()] += rest;
      return fitted;
    }
    for (const Index v : movable) fitted[v] += rest / static_cast<double>(movable.size());
  }
  return Status::InvalidInput(fmt::format(
      "the {} boundary vertices cannot turn as much as Gauss-Bonnet asks of them; add cones",
      boundary_.size()));
}

}  // namespace cirque

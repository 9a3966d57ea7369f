#include "cirque/cones/cone_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/LU>
#include <glog/logging.h>

namespace cirque {
namespace {

constexpr std::size_t kTogether = 16;    ///< cones whose products are made at once
constexpr Eigen::Index kStretch = 2048;  ///< vertices
constexpr int kBySolve = 64;  ///< cones, from which on a solve takes less time than their sum

}  // namespace

ConeFit::ConeFit(const ConeProblem& problem, std::unique_ptr<ConeMeasure> measure)
    : problem_(problem),
      measure_(measure ? std::move(measure) : std::make_unique<AreaMeasure>(problem)),
      without_cones_(problem.LogScaleWithoutCones()),
      constant_(without_cones_.dot(measure_->Apply(without_cones_))) {}

bool ConeFit::AdaptMeasure() {
  if (!measure_->AdaptTo(LogScale())) return false;
  constant_ = without_cones_.dot(measure_->Apply(without_cones_));
  without_products_.clear();
  for (int i = 0; i < size(); ++i) without_products_.push_back(i);
  return true;
}

void ConeFit::Prepare(const std::vector<Index>& vertices) {
  const std::vector<ConeProblem::Response> responses = problem_.Responses(vertices);
  prepared_.clear();
  for (std::size_t i = 0; i < vertices.size(); ++i) prepared_[vertices[i]] = responses[i];
}

void ConeFit::Add(Index vertex) {
  const int n = size() + 1;
  vertices_.push_back(vertex);
  response_.emplace_back();
  gram_.conservativeResize(n, n);
  linear_.conservativeResize(n);
  curvature_.conservativeResize(n);
  curvature_[n - 1] = 0;
  SetResponse(n - 1, vertex);
}

void ConeFit::Move(int i, Index vertex) {
  MakeProducts();
  last_move_ = {i, vertices_[i], std::move(response_[i]), curvature_, gram_.col(i), linear_[i]};
  vertices_[i] = vertex;
  SetResponse(i, vertex);
}

void ConeFit::UndoMove() {
  const int i = last_move_.cone;
  vertices_[i] = last_move_.vertex;
  response_[i] = std::move(last_move_.response);
  curvature_ = std::move(last_move_.curvature);
  gram_.row(i) = last_move_.gram.transpose();
  gram_.col(i) = last_move_.gram;
  linear_[i] = last_move_.linear;
  without_products_.clear();
  ForgetValuesFrom(i);
}

void ConeFit::SetResponse(int i, Index vertex) {
  const auto prepared = prepared_.find(vertex);
  response_[i] =
      prepared == prepared_.end() ? problem_.Responses({vertex}).front() : prepared->second;
  without_products_.push_back(i);
  ForgetValuesFrom(i);
}

/// Rows of the factor from a cone on; of a closed surface all of them are about the first.
void ConeFit::ForgetValuesFrom(int i) {
  const int row = problem_.IsClosed() ? std::max(i - 1, 0) : i;
  values_factored_ = std::min(values_factored_, row);
}

/// Rows of a few cones at once, by stretches of vertices that stay in the processor's cache. Products
/// with cones of later rows are left to these.
void ConeFit::MakeProducts() {
  const Eigen::Index num_vertices = without_cones_.size();
  std::vector<bool> is_later(size(), false);
  for (const int i : without_products_) is_later[i] = true;
  for (std::size_t first = 0; first < without_products_.size(); first += kTogether) {
    const std::size_t end = std::min(without_products_.size(), first + kTogether);
    const auto count = static_cast<Eigen::Index>(end - first);
    ConeMeasure::Columns responses;
    for (std::size_t p = first; p < end; ++p) {
      responses.push_back(response_[without_products_[p]].get());
    }
    const Eigen::MatrixXd weighted = measure_->ApplyToAll(responses);
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(count, size());
    for (Eigen::Index p = 0; p < count; ++p) {
      is_later[without_products_[first + p]] = false;
      linear_[without_products_[first + p]] = weighted.col(p).dot(without_cones_);
    }
    for (Eigen::Index at = 0; at < num_vertices; at += kStretch) {
      const Eigen::Index length = std::min(kStretch, num_vertices - at);
      for (int j = 0; j < size(); ++j) {
        if (is_later[j]) continue;
        rows.col(j).noalias() +=
            weighted.middleRows(at, length).transpose() * response_[j]->segment(at, length);
      }
    }
    for (Eigen::Index p = 0; p < count; ++p) {
      const int i = without_products_[first + p];
      gram_.row(i) = rows.row(p);
      gram_.col(i) = rows.row(p).transpose();
    }
  }
  without_products_.clear();
}

const Eigen::MatrixXd& ConeFit::Gram() {
  MakeProducts();
  return gram_;
}

CurvatureProgram ConeFit::Program() {
  MakeProducts();
  CurvatureProgram program;
  program.gram = gram_;
  program.linear = linear_;
  program.lower.resize(size());
  for (int i = 0; i < size(); ++i) program.lower[i] = problem_.LeastCurvature(vertices_[i]);
  program.upper = Eigen::VectorXd::Constant(size(), problem_.GreatestCurvature());
  if (problem_.IsClosed()) program.total = problem_.TotalCurvature();
  program.start = curvature_;
  return program;
}

bool ConeFit::Fit(const CurvatureProgram& program) {
  const std::optional<Eigen::VectorXd> best = Minimize(program);
  if (!best) return false;
  curvature_ = *best;
  return true;
}

bool ConeFit::FitLeastSquares() { return Fit(Program()); }

bool ConeFit::FitWithout(int i) {
  CurvatureProgram program = Program();
  program.lower[i] = program.upper[i] = 0;
  return Fit(program);
}

void ConeFit::FitZeroAtCones() {
  if (size() == 0) return;
  if (!FactorValuesAtCones() || !FitZeroByFactor()) FitZeroByElimination();
}

/// What a unit of curvature of cone `of` makes of u at cone `at`; on a closed surface the unit comes from
/// the first cone, and u counts from there.
double ConeFit::ValueAtCone(Eigen::Index of, Eigen::Index at) const {
  const Index v = vertices_[at], first = vertices_[0];
  const Eigen::VectorXd &response = *response_[of], &of_first = *response_[0];
  if (!problem_.IsClosed()) return response[v];
  return response[v] - of_first[v] - response[first] + of_first[first];
}

/// False where the matrix is not positive definite in floating point.
bool ConeFit::FactorValuesAtCones() {
  const Eigen::Index skipped = problem_.IsClosed() ? 1 : 0, n = size() - skipped;
  Eigen::MatrixXd& factor = values_factor_;
  factor.conservativeResize(n, n);
  for (Eigen::Index i = values_factored_; i < n; ++i) {
    Eigen::VectorXd row(i);
    for (Eigen::Index j = 0; j < i; ++j) row[j] = ValueAtCone(i + skipped, j + skipped);
    factor.topLeftCorner(i, i).triangularView<Eigen::Lower>().solveInPlace(row);
    const double squared = ValueAtCone(i + skipped, i + skipped) - row.squaredNorm();
    if (!(squared > 0)) return false;
    factor.row(i).head(i) = row.transpose();
    factor(i, i) = std::sqrt(squared);
    values_factored_ = static_cast<int>(i) + 1;
  }
  return true;
}

/// False where that is not finite.
bool ConeFit::FitZeroByFactor() {
  const bool closed = problem_.IsClosed();
  const Eigen::Index skipped = closed ? 1 : 0, n = size() - skipped;
  const double total = closed ? problem_.TotalCurvature() : 0;
  Eigen::VectorXd moved(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Index v = vertices_[i + skipped], first = vertices_[0];
    moved[i] = -without_cones_[v];
    if (!closed) continue;
    moved[i] += without_cones_[first] - total * ((*response_[0])[v] - (*response_[0])[first]);
  }
  values_factor_.triangularView<Eigen::Lower>().solveInPlace(moved);
  values_factor_.transpose().triangularView<Eigen::Upper>().solveInPlace(moved);
  if (!moved.allFinite()) return false;
  if (closed) curvature_[0] = total - moved.sum();
  curvature_.tail(n) = moved;
  return true;
}

void ConeFit::FitZeroByElimination() {
  const int n = size(), closed = problem_.IsClosed();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + closed, n + closed);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + closed);
  for (int i = 0; i < n; ++i) {
    right[i] = -without_cones_[vertices_[i]];
    for (int j = 0; j < n; ++j) matrix(i, j) = (*response_[j])[vertices_[i]];
  }
  if (closed) {
    matrix.row(n).head(n).setOnes();
    matrix.col(n).head(n).setOnes();
    right[n] = problem_.TotalCurvature();
  }
  curvature_ = matrix.partialPivLu().solve(right).head(n);
}

Eigen::VectorXd ConeFit::LogScale() const {
  Eigen::VectorXd u = without_cones_;
  if (size() > kBySolve) {
    Eigen::VectorXd curvature = Eigen::VectorXd::Zero(u.size());
    for (int i = 0; i < size(); ++i) curvature[vertices_[i]] += curvature_[i];
    return u + problem_.Solve(curvature);
  }
  for (int i = 0; i < size(); ++i) u += curvature_[i] * *response_[i];
  return u;
}

double ConeFit::Distortion() {
  MakeProducts();
  double squared = constant_;
  if (size() > 0) squared += curvature_.dot(gram_ * curvature_ + 2 * linear_);
  return std::sqrt(std::max(squared, 0.0));
}

Eigen::VectorXd ConeFit::Descent() const { return problem_.Solve(measure_->Apply(LogScale())); }

std::vector<Cone> ConeFit::Cones() const {
  std::vector<Cone> cones;
  for (int i = 0; i < size(); ++i) cones.push_back(ConeOfCurvature(vertices_[i], curvature_[i]));
  return cones;
}

}  // namespace cirque

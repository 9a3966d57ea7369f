#include "cirque/cones/cone_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/LU>
#include <glog/logging.h>

namespace cirque {

ConeFit::ConeFit(const ConeProblem& problem, std::unique_ptr<ConeMeasure> measure)
    : problem_(problem),
      measure_(measure ? std::move(measure) : std::make_unique<AreaMeasure>(problem)),
      without_cones_(problem.LogScaleWithoutCones()),
      constant_(without_cones_.dot(measure_->Apply(without_cones_))) {}

bool ConeFit::AdaptMeasure() {
  if (!measure_->AdaptTo(LogScale())) return false;
  constant_ = without_cones_.dot(measure_->Apply(without_cones_));
  for (int i = 0; i < size(); ++i) SetProducts(i);
  return true;
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
  last_move_ = {i, vertices_[i], std::move(response_[i]), curvature_};
  vertices_[i] = vertex;
  SetResponse(i, vertex);
}

void ConeFit::UndoMove() {
  const int i = last_move_.cone;
  vertices_[i] = last_move_.vertex;
  response_[i] = std::move(last_move_.response);
  curvature_ = std::move(last_move_.curvature);
  SetProducts(i);
}

void ConeFit::SetResponse(int i, Index vertex) {
  CHECK(problem_.IsCandidate(vertex)) << vertex;
  Eigen::VectorXd unit = Eigen::VectorXd::Zero(problem_.triangulation().num_vertices);
  unit[vertex] = 1;
  response_[i] = problem_.Solve(unit);
  SetProducts(i);
}

void ConeFit::SetProducts(int i) {
  const Eigen::VectorXd weighted = measure_->Apply(response_[i]);
  for (int j = 0; j < size(); ++j) gram_(i, j) = gram_(j, i) = weighted.dot(response_[j]);
  linear_[i] = weighted.dot(without_cones_);
}

CurvatureProgram ConeFit::Program() const {
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
  const int n = size(), closed = problem_.IsClosed();
  if (n == 0) return;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + closed, n + closed);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + closed);
  for (int i = 0; i < n; ++i) {
    right[i] = -without_cones_[vertices_[i]];
    for (int j = 0; j < n; ++j) matrix(i, j) = response_[j][vertices_[i]];
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
  for (int i = 0; i < size(); ++i) u += curvature_[i] * response_[i];
  return u;
}

double ConeFit::Distortion() const {
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

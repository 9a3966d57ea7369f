#include "cirque/cones/cone_measure.h"

#include <algorithm>
#include <cmath>

namespace cirque {
namespace {

constexpr double kGreatestRadius = 4;  ///< over the longest side
constexpr double kLeastArea = 1e-3;    ///< over its square
constexpr double kSmoothing = 0.05;    ///< over the mean of the measure

double Squared(double x) { return x * x; }

}  // namespace

double AreaMeasure::Value(const Eigen::VectorXd& u) const {
  return std::sqrt(area_.dot(u.cwiseAbs2()));
}

Eigen::VectorXd AreaMeasure::Shares(const Eigen::VectorXd& u) const {
  return area_.cwiseProduct(u.cwiseAbs2());
}

AngleMeasure::AngleMeasure(const ConeProblem& problem)
    : triangulation_(problem.source().surface->triangulation),
      area_(triangulation_.num_faces()),
      side_(triangulation_.num_halfedges()),
      weight_(Eigen::VectorXd::Ones(triangulation_.num_faces())) {
  const Eigen::VectorXd& length = problem.source().surface->lengths.value;
  for (Index f = 0; f < triangulation_.num_faces(); ++f) {
    std::array<double, 3> l;
    for (int k = 0; k < 3; ++k) l[k] = length[triangulation_.edge[3 * f + k]];
    const double longest = std::max({l[0], l[1], l[2]});
    const double s = 0.5 * (l[0] + l[1] + l[2]);
    const double heron = std::max(s * (s - l[0]) * (s - l[1]) * (s - l[2]), 0.0);
    area_[f] = std::max(std::sqrt(heron), kLeastArea * Squared(longest));
    const double radius = std::min(l[0] * l[1] * l[2] / (4 * area_[f]), kGreatestRadius * longest);
    // |grad u|^2 = sum over the sides of cot(angle opposite) (difference of u)^2 / (2 area).
    for (int k = 0; k < 3; ++k) {
      const double dot = 0.5 * (Squared(l[(k + 1) % 3]) + Squared(l[(k + 2) % 3]) - Squared(l[k]));
      side_[3 * f + k] = dot * Squared(radius / (2 * area_[f]));
    }
  }
  area_ /= area_.sum();
}

double AngleMeasure::Predicted(Index f, const Eigen::VectorXd& u) const {
  double squared = 0;
  for (Index h = 3 * f; h < 3 * f + 3; ++h) {
    squared += side_[h] * Squared(u[triangulation_.Tip(h)] - u[triangulation_.Tail(h)]);
  }
  return std::sqrt(std::max(squared, 0.0));
}

Eigen::VectorXd AngleMeasure::Apply(const Eigen::VectorXd& u) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(u.size());
  for (Index f = 0; f < triangulation_.num_faces(); ++f) {
    const Index* vertex = triangulation_.vertex.data() + 3 * f;
    const double at[] = {u[vertex[0]], u[vertex[1]], u[vertex[2]]}, weight = weight_[f] * area_[f];
    for (int i = 0; i < 3; ++i) {
      const int tail = (i + 1) % 3, tip = (i + 2) % 3;
      const double flow = weight * side_[3 * f + i] * (at[tip] - at[tail]);
      result[vertex[tip]] += flow;
      result[vertex[tail]] -= flow;
    }
  }
  return result;
}

double AngleMeasure::Value(const Eigen::VectorXd& u) const {
  double sum = 0;
  for (Index f = 0; f < triangulation_.num_faces(); ++f) sum += area_[f] * Predicted(f, u);
  return sum;
}

Eigen::VectorXd AngleMeasure::Shares(const Eigen::VectorXd& u) const {
  Eigen::VectorXd share = Eigen::VectorXd::Zero(u.size());
  for (Index f = 0; f < triangulation_.num_faces(); ++f) {
    const double third = area_[f] * Predicted(f, u) / 3;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) share[triangulation_.vertex[h]] += third;
  }
  return share;
}

bool AngleMeasure::AdaptTo(const Eigen::VectorXd& u) {
  if (delta_ == 0) delta_ = kSmoothing * Value(u);
  if (delta_ == 0) return false;
  for (Index f = 0; f < triangulation_.num_faces(); ++f) {
    weight_[f] = 1 / std::hypot(Predicted(f, u), delta_);
  }
  return true;
}

std::unique_ptr<ConeMeasure> MakeConeMeasure(ConeMeasureKind kind, const ConeProblem& problem) {
  if (kind == ConeMeasureKind::kAngle) return std::make_unique<AngleMeasure>(problem);
  return std::make_unique<AreaMeasure>(problem);
}

}  // namespace cirque

#include "cirque/cones/cone_measure.h"

#include <algorithm>
#include <cmath>

namespace cirque {
namespace {

constexpr double kGreatestRadius = 4;  ///< over the longest side
constexpr double kLeastArea = 1e-3;    ///< over its square
constexpr double kSmoothing = 0.05;    ///< over the mean of the measure
constexpr int kTogether = 8;           ///< columns to which a form is applied at once
constexpr std::size_t kFewest = 3;     ///< for which that takes less time

double Squared(double x) { return x * x; }

}  // namespace

Eigen::MatrixXd ConeMeasure::ApplyToAll(const Columns& u) const {
  Eigen::MatrixXd result(u.empty() ? 0 : u.front()->size(), u.size());
  for (std::size_t k = 0; k < u.size(); ++k) {
    result.col(static_cast<Eigen::Index>(k)) = Apply(*u[k]);
  }
  return result;
}

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
      stiffness_(triangulation_.num_edges()) {
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
  for (const Index h : triangulation_.edge_halfedge) {
    ends_.push_back({triangulation_.Tail(h), triangulation_.Tip(h)});
  }
  SetStiffness([](Index /*f*/) { return 1.0; });
}

/// `weight`: of the faces in the form.
template <class Weight>
void AngleMeasure::SetStiffness(const Weight& weight) {
  stiffness_.setZero();
  for (Index f = 0; f < triangulation_.num_faces(); ++f) {
    const double of_face = weight(f) * area_[f];
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      stiffness_[triangulation_.edge[h]] += of_face * side_[h];
    }
  }
}

double AngleMeasure::Predicted(Index f, const Eigen::VectorXd& u) const {
  const Index* vertex = triangulation_.vertex.data() + 3 * f;
  const double *side = side_.data() + 3 * f, a = u[vertex[0]], b = u[vertex[1]], c = u[vertex[2]];
  const double squared =
      side[0] * Squared(c - b) + side[1] * Squared(a - c) + side[2] * Squared(b - a);
  return std::sqrt(std::max(squared, 0.0));
}

Eigen::VectorXd AngleMeasure::Apply(const Eigen::VectorXd& u) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(u.size());
  for (std::size_t e = 0; e < ends_.size(); ++e) {
    const auto [tail, tip] = ends_[e];
    const double flow = stiffness_[static_cast<Index>(e)] * (u[tip] - u[tail]);
    result[tip] += flow;
    result[tail] -= flow;
  }
  return result;
}

Eigen::MatrixXd AngleMeasure::ApplyToAll(const Columns& u) const {
  if (u.size() < kFewest) return ConeMeasure::ApplyToAll(u);
  Eigen::MatrixXd result(u.front()->size(), u.size());
  for (std::size_t first = 0; first < u.size(); first += kTogether) {
    ApplyTogether(u, first, std::min(u.size(), first + kTogether), &result);
  }
  return result;
}

/// At most kTogether columns, whose values at a vertex lie side by side on the way.
void AngleMeasure::ApplyTogether(const Columns& u, std::size_t first, std::size_t end,
                                 Eigen::MatrixXd* result) const {
  using Interleaved = Eigen::Matrix<double, kTogether, Eigen::Dynamic>;
  Interleaved at = Interleaved::Zero(kTogether, u.front()->size()), flowed = at;
  for (std::size_t k = first; k < end; ++k) {
    at.row(static_cast<Eigen::Index>(k - first)) = u[k]->transpose();
  }
  for (std::size_t e = 0; e < ends_.size(); ++e) {
    const auto [tail, tip] = ends_[e];
    const Eigen::Matrix<double, kTogether, 1> flow =
        stiffness_[static_cast<Index>(e)] * (at.col(tip) - at.col(tail));
    flowed.col(tip) += flow;
    flowed.col(tail) -= flow;
  }
  for (std::size_t k = first; k < end; ++k) {
    result->col(static_cast<Eigen::Index>(k)) =
        flowed.row(static_cast<Eigen::Index>(k - first)).transpose();
  }
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
  const double squared_delta = Squared(delta_);
  SetStiffness([&](Index f) { return 1 / std::sqrt(Squared(Predicted(f, u)) + squared_delta); });
  return true;
}

std::unique_ptr<ConeMeasure> MakeConeMeasure(ConeMeasureKind kind, const ConeProblem& problem) {
  if (kind == ConeMeasureKind::kAngle) return std::make_unique<AngleMeasure>(problem);
  return std::make_unique<AreaMeasure>(problem);
}

}  // namespace cirque

#include "cirque/angles/infeasibility.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cirque/core/parallel.h"
#include "cirque/math/compensated_sum.h"

namespace cirque {
namespace {

constexpr int kMaxDenominator = 12;  ///< of the integer multiples that are tried
/// Share of sum |terms| that the margin must exceed: far above rounding, so that the exact check is
/// asked only what it will confirm.
constexpr double kSafety = 1e-9;
constexpr int kMaxCarriers = 50;
constexpr double kStays = 1e-2;  ///< a step of this share of the multipliers runs nowhere

/// max of p a + q b over the triangle with corners (eps, eps), (1 - 2 eps, eps), (eps, 1 - 2 eps).
double SupportOfTriangle(double p, double q, double eps) {
  return eps * (p + q) + (1 - 3 * eps) * std::max({0.0, p, q});
}

/// max of p a over [eps, 1 - eps].
double SupportOfInterval(double p, double eps) { return p > 0 ? p * (1 - eps) : p * eps; }

struct Margin {
  double value = 0, magnitude = 0;  ///< the margin and the sum of its terms' absolute values
};

/// Adds term(i), i in [0, n).
template <class Term>
Margin SumTerms(int n, const Term& term) {
  std::vector<CompensatedSum> value(NumBlocks(n));
  std::vector<double> magnitude(NumBlocks(n), 0);
  ForEachBlock(n, [&](int block, int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const double x = term(i);
      value[block] += x;
      magnitude[block] += std::abs(x);
    }
  });
  CompensatedSum sum;
  for (const CompensatedSum& of_block : value) sum += of_block;
  return {sum.Value(), std::accumulate(magnitude.begin(), magnitude.end(), 0.0)};
}

Margin ComputeMargin(const AngleConstraints& constraints, double epsilon,
                     const Eigen::VectorXd& y) {
  const Triangulation& t = constraints.triangulation();
  const double eps = epsilon / kPi;
  const Margin of_rows = SumTerms(constraints.num_rows(), [&](int row) {
    return y[row] * (y[row] > 0 ? constraints.Lower(row) : constraints.Upper(row)) / kPi;
  });
  const Margin of_edges = SumTerms(t.num_edges(), [&](Index e) {
    const Index h = t.edge_halfedge[e];
    const double p = constraints.Slope(y.data(), h);
    return t.twin[h] == kNone ? -SupportOfInterval(p, eps)
                              : -SupportOfTriangle(p, constraints.Slope(y.data(), t.twin[h]), eps);
  });
  return {of_rows.value + of_edges.value, of_rows.magnitude + of_edges.magnitude};
}

/// The ids of the entries with the largest absolute values, those within a thousandth of the
/// largest.
std::vector<Index> Carriers(const Eigen::VectorXd& multipliers, const std::vector<Index>& ids) {
  std::vector<Index> order(multipliers.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return std::abs(multipliers[a]) > std::abs(multipliers[b]);
  });
  std::vector<Index> carriers;
  for (const Index i : order) {
    const double largest = std::abs(multipliers[order.front()]);
    if (static_cast<int>(carriers.size()) == kMaxCarriers ||
        std::abs(multipliers[i]) <= 1e-3 * largest) {
      break;
    }
    carriers.push_back(ids.empty() ? i : ids[i]);
  }
  return carriers;
}

/// The certificate of these multipliers; empty when its numbers, taken exactly, certify nothing.
InfeasibilityCertificate MakeInfeasibilityCertificate(const AngleConstraints& constraints,
                                                      double epsilon, const Eigen::VectorXd& y,
                                                      double margin) {
  InfeasibilityCertificate certificate;
  const int faces = constraints.num_faces();
  certificate.epsilon_over_pi = epsilon / kPi;
  certificate.margin = margin;
  certificate.constrained_vertex = constraints.constrained_vertices();
  certificate.face_multiplier.assign(y.data(), y.data() + faces);
  certificate.vertex_multiplier.assign(y.data() + faces, y.data() + y.size());
  for (int row = faces; row < constraints.num_rows(); ++row) {
    certificate.lower_over_pi.push_back(constraints.Lower(row) / kPi);
    certificate.upper_over_pi.push_back(constraints.Upper(row) / kPi);
  }
  certificate.carrying_faces = Carriers(y.head(faces), {});
  certificate.carrying_vertices =
      Carriers(y.tail(y.size() - faces), certificate.constrained_vertex);
  return HoldsExactly(constraints.triangulation(), certificate) ? certificate
                                                                : InfeasibilityCertificate();
}

/// At margin 0 the inequality may hold with equality (the conditions are open), which only exact
/// multipliers show.
InfeasibilityCertificate CertifyWithIntegers(const AngleConstraints& constraints,
                                             const Eigen::VectorXd& unit) {
  for (int denominator = 1; denominator <= kMaxDenominator; ++denominator) {
    const Eigen::VectorXd y = (unit * denominator).array().round().matrix();
    const Margin margin = ComputeMargin(constraints, 0, y);
    // Multiples of pi / k as targets are the rule; they and integers leave errors of a few ulp of
    // the whole sum.
    if (margin.value >= -1e-13 * margin.magnitude && margin.magnitude > 0 &&
        InfeasibilityMargin(constraints, 1e-6, y) > 0) {
      InfeasibilityCertificate certificate =
          MakeInfeasibilityCertificate(constraints, 0, y, std::max(0.0, margin.value));
      if (!certificate.empty()) return certificate;
    }
  }
  return {};
}

}  // namespace

double InfeasibilityMargin(const AngleConstraints& constraints, double epsilon,
                           const Eigen::VectorXd& y) {
  return ComputeMargin(constraints, epsilon, y).value;
}

InfeasibilityCertificate FindInfeasibilityCertificate(const AngleConstraints& constraints,
                                                      double epsilon, const Eigen::VectorXd& y) {
  const double largest = y.lpNorm<Eigen::Infinity>();
  if (!(largest > 0) || !std::isfinite(largest)) return {};
  const Eigen::VectorXd unit = y / largest;
  const Margin with_epsilon = ComputeMargin(constraints, epsilon, unit);
  if (!(with_epsilon.value > kSafety * with_epsilon.magnitude)) return {};
  const Margin without = ComputeMargin(constraints, 0, unit);
  if (without.value > kSafety * without.magnitude) {
    InfeasibilityCertificate certificate =
        MakeInfeasibilityCertificate(constraints, 0, unit, without.value);
    if (!certificate.empty()) return certificate;
  }
  InfeasibilityCertificate exact = CertifyWithIntegers(constraints, unit);
  return exact.empty()
             ? MakeInfeasibilityCertificate(constraints, epsilon, unit, with_epsilon.value)
             : exact;
}

InfeasibilityCertificate InfeasibilityCertificateFrom(const AngleConstraints& constraints,
                                                      const Eigen::VectorXd& y) {
  return MakeInfeasibilityCertificate(constraints, 0, y,
                                      std::max(0.0, ComputeMargin(constraints, 0, y).value));
}

bool InfeasibilityWatch::Found(const Eigen::VectorXd& y) {
  if (!certificate_.empty()) return true;
  if (margin_ < 0) return false;
  const bool first = previous_.size() != y.size();
  const Eigen::VectorXd step = first ? y : y - previous_;
  if (step.lpNorm<Eigen::Infinity>() > kStays * y.lpNorm<Eigen::Infinity>()) {
    certificate_ = FindInfeasibilityCertificate(constraints_, margin_, y);
    if (certificate_.empty() && !first)
      certificate_ = FindInfeasibilityCertificate(constraints_, margin_, step);
  }
  previous_ = y;
  return !certificate_.empty();
}

}  // namespace cirque

// First and second derivatives by the order of Taylor remainders, and the symmetry of the second.
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "experiments/audit_energies/checks.h"

namespace cirque::audit_energies {
namespace {

using Eigen::VectorXd;

constexpr int kHalvings = 10;
/// Remainders below this many times the measured noise of rounding say nothing.
constexpr double kOverNoise = 50;

/// What rounding does to f near x: the largest |second difference| over steps so short that nothing
/// else is in it, and 2e-14 of the terms (element functions promise 1e-13), whose magnitude is
/// given.
template <class Function>
double Noise(const Function& f, const VectorXd& x, const VectorXd& p, double step,
             double magnitude) {
  const auto here = f(x);
  double noise = 0;
  for (const double factor : {1e-7, 1.3e-7, 1.7e-7, 2.3e-7, 3.1e-7}) {
    const VectorXd move = factor * step * p;
    const auto plus = f(x + move), minus = f(x - move);
    noise = std::max(noise, ((plus - here) + (minus - here)).template lpNorm<Eigen::Infinity>());
  }
  return noise + 2e-14 * magnitude;
}

/// By how much the order at which remainder(h) falls from h = step on is short of `order`: measured
/// over the last factor 4 of h before rounding takes over. 0 if it is rounding from the start; NaN
/// if the energy refuses a point.
template <class Remainder>
double Shortfall(const Remainder& remainder, double step, double noise, double order) {
  std::array<double, kHalvings> size;
  int last = -1;
  for (int k = 0; k < kHalvings; ++k) {
    size[k] = remainder(std::ldexp(step, -k));
    if (std::isnan(size[k])) return std::nan("");
    if (size[k] > kOverNoise * noise && last == k - 1) last = k;
  }
  if (last < 2) return 0;
  return order - 0.5 * std::log2(size[last - 2] / size[last]);
}

/// The energy's value as a vector of one entry, so that values and gradients are treated alike.
auto ValueOf(const Energy& energy) {
  return [&energy](const VectorXd& x) -> VectorXd {
    return VectorXd::Constant(1, ValueAt(energy, x));
  };
}

auto GradientOf(const Energy& energy) {
  return [&energy](const VectorXd& x) -> VectorXd { return GradientAt(energy, x); };
}

/// The shortfall of f(x + hp) - model(hp) from `order`. The model gets the displacement as rounded.
template <class Function, class Model>
double TaylorShortfall(const Function& f, const Model& model, const AuditPoint& point,
                       const VectorXd& p, double magnitude, double order) {
  const double noise = Noise(f, point.x, p, point.step, magnitude);
  if (std::isnan(noise)) return noise;
  const auto remainder = [&](double h) {
    const VectorXd moved = point.x + h * p;
    return (f(moved) - model(moved - point.x)).template lpNorm<Eigen::Infinity>();
  };
  return Shortfall(remainder, point.step, noise, order);
}

/// The magnitude of the energy's terms at the point.
double Magnitude(const Subject& s, const AuditPoint& point) {
  const Reals x(point.x.begin(), point.x.end());
  return static_cast<double>(s.reference(*s.audit_case.input, x).magnitude);
}

}  // namespace

void CheckGradient(const Subject& s, Finding* finding) {
  for (const AuditPoint& point : s.audit_case.inside) {
    const double value = ValueAt(s.energy, point.x), magnitude = Magnitude(s, point);
    const VectorXd gradient = GradientAt(s.energy, point.x);
    const auto model = [&](const VectorXd& move) -> VectorXd {
      return VectorXd::Constant(1, value + gradient.dot(move));
    };
    for (const VectorXd& p : Directions(static_cast<int>(point.x.size()))) {
      finding->Note(TaylorShortfall(ValueOf(s.energy), model, point, p, magnitude, 2),
                    s.Where(point, "order of E(x + hp) - E - h g.p short of 2"));
    }
  }
}

void CheckHessian(const Subject& s, Finding* finding) {
  for (const AuditPoint& point : s.audit_case.inside) {
    const double value = ValueAt(s.energy, point.x), magnitude = Magnitude(s, point);
    const VectorXd gradient = GradientAt(s.energy, point.x);
    const Eigen::MatrixXd hessian = HessianAt(s.energy, point.x);
    const auto quadratic = [&](const VectorXd& move) -> VectorXd {
      return VectorXd::Constant(1, value + (gradient + 0.5 * (hessian * move)).dot(move));
    };
    const auto linear = [&](const VectorXd& move) -> VectorXd { return gradient + hessian * move; };
    const double largest = gradient.lpNorm<Eigen::Infinity>();
    for (const VectorXd& p : Directions(static_cast<int>(point.x.size()))) {
      finding->Note(TaylorShortfall(ValueOf(s.energy), quadratic, point, p, magnitude, 3),
                    s.Where(point, "order of E(x + hp) - E - h g.p - h^2/2 p.Hp short of 3"));
      finding->Note(TaylorShortfall(GradientOf(s.energy), linear, point, p, 1 + largest, 2),
                    s.Where(point, "order of g(x + hp) - g - h Hp short of 2"));
    }
  }
}

void CheckSymmetry(const Subject& s, Finding* finding) {
  for (const AuditPoint& point : s.audit_case.inside) {
    SparseMatrix lower;
    s.energy.Hessian(point.x.data(), &lower);
    int above = 0;
    for (int j = 0; j < lower.outerSize(); ++j) {
      for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry) above += entry.row() < j;
    }
    finding->Note(above, s.Where(point, fmt::format("{} entries above the diagonal", above)));
    const auto directions = Directions(static_cast<int>(point.x.size()));
    const double h = 1e-4 * point.step;
    std::vector<VectorXd> moves, changes;
    double largest = 0, size = 0;
    for (const VectorXd& p : directions) {
      const VectorXd ahead = point.x + h * p, behind = point.x - h * p;
      const VectorXd plus = GradientAt(s.energy, ahead), minus = GradientAt(s.energy, behind);
      moves.push_back((ahead - behind) / (2 * h));
      changes.push_back((plus - minus) / (2 * h));
      size = std::max(size, plus.lpNorm<Eigen::Infinity>());
      largest = std::max(largest, changes.back().lpNorm<1>());
    }
    // The second term allows for rounding of the gradients, 1e-13 of their size.
    const double scale = largest + 1e-7 * (1 + size) / h;
    for (std::size_t i = 0; i < changes.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const double difference = changes[i].dot(moves[j]) - changes[j].dot(moves[i]);
        finding->Note(
            std::abs(difference) / scale,
            s.Where(point, "q.dg(p) - p.dg(q), relative: the derivative of the gradient"));
      }
    }
  }
}

}  // namespace cirque::audit_energies

// First and second derivatives by the order of Taylor remainders, and the symmetry of the second.
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "cirque/audit/checks.h"

namespace cirque {
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

double Magnitude(const AuditPoint& point, double value) {
  return point.magnitude > 0 ? point.magnitude : std::abs(value);
}

}  // namespace

void CheckGradient(const AuditCase& c, AuditFinding* finding) {
  for (const AuditPoint& point : c.inside) {
    const double value = ValueAt(*c.energy, point.x), magnitude = Magnitude(point, value);
    const VectorXd gradient = GradientAt(*c.energy, point.x);
    const auto model = [&](const VectorXd& move) -> VectorXd {
      return VectorXd::Constant(1, value + gradient.dot(move));
    };
    for (const VectorXd& p : Directions(static_cast<int>(point.x.size()))) {
      finding->Note(TaylorShortfall(ValueOf(*c.energy), model, point, p, magnitude, 2),
                    c.Where(point, "order of E(x + hp) - E - h g.p short of 2"));
    }
  }
}

void CheckHessian(const AuditCase& c, AuditFinding* finding) {
  for (const AuditPoint& point : c.inside) {
    const double value = ValueAt(*c.energy, point.x), magnitude = Magnitude(point, value);
    const VectorXd gradient = GradientAt(*c.energy, point.x);
    const Eigen::MatrixXd hessian = HessianAt(*c.energy, point.x);
    const auto quadratic = [&](const VectorXd& move) -> VectorXd {
      return VectorXd::Constant(1, value + (gradient + 0.5 * (hessian * move)).dot(move));
    };
    const auto linear = [&](const VectorXd& move) -> VectorXd { return gradient + hessian * move; };
    const double largest = gradient.lpNorm<Eigen::Infinity>();
    for (const VectorXd& p : Directions(static_cast<int>(point.x.size()))) {
      finding->Note(TaylorShortfall(ValueOf(*c.energy), quadratic, point, p, magnitude, 3),
                    c.Where(point, "order of E(x + hp) - E - h g.p - h^2/2 p.Hp short of 3"));
      finding->Note(TaylorShortfall(GradientOf(*c.energy), linear, point, p, 1 + largest, 2),
                    c.Where(point, "order of g(x + hp) - g - h Hp short of 2"));
    }
  }
}

void CheckSymmetry(const AuditCase& c, AuditFinding* finding) {
  for (const AuditPoint& point : c.inside) {
    SparseMatrix lower;
    c.energy->Hessian(point.x.data(), &lower);
    int above = 0;
    for (int j = 0; j < lower.outerSize(); ++j) {
      for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry) above += entry.row() < j;
    }
    finding->Note(above, c.Where(point, fmt::format("{} entries above the diagonal", above)));
    const auto directions = Directions(static_cast<int>(point.x.size()));
    const double h = 1e-4 * point.step;
    std::vector<VectorXd> moves, changes;
    double largest = 0, size = 0;
    for (const VectorXd& p : directions) {
      const VectorXd ahead = point.x + h * p, behind = point.x - h * p;
      const VectorXd plus = GradientAt(*c.energy, ahead), minus = GradientAt(*c.energy, behind);
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
            c.Where(point, "q.dg(p) - p.dg(q), relative: the derivative of the gradient"));
      }
    }
  }
}

}  // namespace cirque

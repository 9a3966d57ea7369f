#include "cirque/layout/half_plane.h"

#include <algorithm>
#include <cmath>

#include "cirque/layout/moebius_normalization.h"

namespace cirque {

HalfPlane MoveToHalfPlane(const Triangulation& t, const CornerUv& layout,
                          const std::vector<Index>& chain) {
  HalfPlane result;
  std::vector<Complex>& z = result.position;
  z.resize(t.num_vertices);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    z[t.vertex[h]] = {layout.value[h].x(), layout.value[h].y()};
  }
  const Complex origin = z[chain.front()], span = z[chain.back()] - origin;
  for (Complex& p : z) p = (p - origin) / span;
  result.increasing = true;
  for (std::size_t k = 0; k < chain.size(); ++k) {
    result.straightness = std::max(result.straightness, std::abs(z[chain[k]].imag()));
    z[chain[k]] = z[chain[k]].real();
    if (k > 0 && !(z[chain[k - 1]].real() < z[chain[k]].real())) result.increasing = false;
  }
  return result;
}

namespace {

/// Stereographic from the south pole of the sphere.
Eigen::Vector3d ToHemisphere(Complex w) {
  const double s = std::norm(w);
  return Eigen::Vector3d(2 * w.real(), 2 * w.imag(), 1 - s) / (1 + s);
}

}  // namespace

Complex BalancingPoint(const WeightedPoints& points, Complex start, const SolveControl& control) {
  const Moebius to_disk = Moebius::Cayley(start);
  std::vector<Eigen::Vector3d> on_sphere;
  std::vector<double> weights;
  for (std::size_t i = 0; i < points.point.size(); ++i) {
    const ExtendedComplex& z = points.point[i];
    const Eigen::Vector3d p = ToHemisphere(to_disk(z).value);
    const bool on_circle = z.is_infinite || z.value.imag() == 0;
    on_sphere.push_back(on_circle ? Eigen::Vector3d(p.x(), p.y(), 0).normalized() : p);
    weights.push_back(on_circle ? points.weight[i] : 0.5 * points.weight[i]);
    if (on_circle) continue;
    on_sphere.emplace_back(p.x(), p.y(), -p.z());
    weights.push_back(0.5 * points.weight[i]);
  }
  SolverLimits limits;
  limits.gradient_tolerance = 1e-15;
  const LorentzNormalization balance = MinimizeLorentz(on_sphere, weights, limits, control);
  if (balance.summary.termination == Termination::kInvalidStart) return start;
  Complex preimage = 0;  // of the centre, in the disk
  for (auto boost = balance.boosts.rbegin(); boost != balance.boosts.rend(); ++boost) {
    const Complex y(boost->centre().x(), boost->centre().y());
    preimage = (preimage + y) / (1.0 + std::conj(y) * preimage);
  }
  const Complex c = (start - std::conj(start) * preimage) / (1.0 - preimage);
  return c.imag() > 0 && std::isfinite(c.real()) && std::isfinite(c.imag()) ? c : start;
}

double CentreOfMass(const std::vector<Complex>& points, const std::vector<double>& weights) {
  Complex sum = 0;
  double total = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += weights[i] * 2.0 / (1 + std::norm(points[i])) * points[i];
    total += weights[i];
  }
  return std::abs(sum) / total;
}

void FillAngles(const std::vector<double>& arc, std::vector<double>* angles) {
  std::size_t before = 0;
  for (std::size_t k = 1; k <= arc.size(); ++k) {
    if (k < arc.size() && std::isnan((*angles)[k])) continue;
    const double end_angle = k < arc.size() ? (*angles)[k] : 2 * kPi;
    const double end_arc = k < arc.size() ? arc[k] : 1;
    const double slope = (end_angle - (*angles)[before]) / (end_arc - arc[before]);
    for (std::size_t i = before + 1; i < k; ++i) {
      (*angles)[i] = (*angles)[before] + slope * (arc[i] - arc[before]);
    }
    before = k;
  }
}

double WeightedMedian(std::vector<std::pair<double, double>> value_and_weight) {
  std::sort(value_and_weight.begin(), value_and_weight.end());
  double total = 0, sum = 0;
  for (const auto& [unused, weight] : value_and_weight) total += weight;
  for (const auto& [value, weight] : value_and_weight) {
    sum += weight;
    if (2 * sum >= total) return value;
  }
  return value_and_weight.back().first;
}

}  // namespace cirque

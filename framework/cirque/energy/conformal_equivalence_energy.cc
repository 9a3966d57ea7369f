#include "cirque/energy/conformal_equivalence_energy.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glog/logging.h>

#include "cirque/core/parallel.h"
#include "cirque/energy/assemble_lower.h"
#include "cirque/math/clausen.h"
#include "cirque/math/compensated_sum.h"

namespace cirque {

EquivalenceJet EquivalenceElement(const std::array<double, 3>& x, const LogTriangle& triangle) {
  // 2 sum alpha_k - 3 pi = -pi: what all sides have in common comes out of the sums exactly.
  const double common = *std::max_element(x.begin(), x.end());
  EquivalenceJet jet;
  jet.value = -kPi * common;
  for (int k = 0; k < 3; ++k) {
    const double angle = triangle.angle[k];
    jet.slope[k] = 2 * angle - kPi;
    jet.value += jet.slope[k] * (x[k] - common) + 2 * Lobachevsky(angle);
    jet.cotangent[k] = triangle.Cotangent(k);
  }
  return jet;
}

ScaleTargets TargetsOfScales(const ConeTargets& targets) {
  ScaleTargets scales;
  std::vector<double> sums;
  for (std::size_t v = 0; v < targets.lower.size(); ++v) {
    const bool fixed = targets.IsFixed(static_cast<int>(v));
    scales.parameter.push_back(fixed ? static_cast<int>(sums.size()) : kNone);
    if (fixed) sums.push_back(targets.lower[v]);
  }
  scales.angle_sum = Eigen::Map<const Eigen::VectorXd>(sums.data(), static_cast<int>(sums.size()));
  return scales;
}

ConformalEquivalenceEnergy::ConformalEquivalenceEnergy(const Triangulation& t,
                                                       const Eigen::VectorXd& log_lengths,
                                                       ScaleTargets targets, Flips flips,
                                                       const std::vector<TripleDouble>& scaled_by)
    : targets_(std::move(targets)), flips_(flips), complex_(t, log_lengths, scaled_by) {
  CHECK_EQ(static_cast<Index>(targets_.parameter.size()), t.num_vertices);
  CHECK_EQ(log_lengths.size(), t.num_edges());
  scale_ = Eigen::VectorXd::Zero(t.num_vertices);
}

Eigen::VectorXd ConformalEquivalenceEnergy::ScaleOfVertices(const double* u) const {
  Eigen::VectorXd scale = Eigen::VectorXd::Zero(static_cast<int>(targets_.parameter.size()));
  for (int v = 0; v < scale.size(); ++v) {
    if (targets_.parameter[v] != kNone) scale[v] = u[targets_.parameter[v]];
  }
  return scale;
}

bool ConformalEquivalenceEnergy::MoveTo(const double* u) const {
  if (!AllFinite(u)) return false;
  Eigen::VectorXd scale = ScaleOfVertices(u);
  if (has_moved_ && scale == scale_) return true;
  scale_.swap(scale);
  if (flips_ == Flips::kPtolemy) return has_moved_ = complex_.MakeDelaunay(scale_, &triangles_);
  triangles_.resize(static_cast<std::size_t>(complex_.num_faces()));
  ParallelFor(complex_.num_faces(),
              [&](Index f) { triangles_[f] = complex_.ScaledTriangle(f, scale_); });
  return has_moved_ = true;
}

void ConformalEquivalenceEnergy::AddSlopes(double* gradient) const {
  Eigen::Map<Eigen::VectorXd>(gradient, NumParameters()) = targets_.angle_sum;
  for (Index h = 0; h < complex_.num_halfedges(); ++h) {
    const int p = targets_.parameter[complex_.vertex(h)];
    if (p != kNone) gradient[p] -= triangles_[Triangulation::Face(h)].angle[h % 3];
  }
}

bool ConformalEquivalenceEnergy::Evaluate(const double* u, double* value, double* gradient) const {
  if (!MoveTo(u)) return false;
  const double of_faces = ParallelSum(complex_.num_faces(), [&](Index f) {
    std::array<double, 3> x;
    for (int k = 0; k < 3; ++k) x[k] = complex_.ScaledLogLength(3 * f + k, scale_);
    return EquivalenceElement(x, triangles_[f]).value;
  });
  const double of_targets =
      ParallelSum(NumParameters(), [&](int p) { return targets_.angle_sum[p] * u[p]; });
  *value = of_faces + of_targets;
  if (!std::isfinite(*value)) return false;
  if (gradient) AddSlopes(gradient);
  return true;
}

bool ConformalEquivalenceEnergy::Gradient(const double* u, double* gradient) const {
  if (!MoveTo(u)) return false;
  AddSlopes(gradient);
  return true;
}

bool ConformalEquivalenceEnergy::Hessian(const double* u, SparseMatrix* lower) const {
  if (!MoveTo(u)) return false;
  const auto for_each_entry = [&](const auto& add) {
    for (int p = 0; p < NumParameters(); ++p) add(p, p, 0.0);
    for (Index h = 0; h < complex_.num_halfedges(); ++h) {
      const int i = targets_.parameter[complex_.vertex(Triangulation::Next(h))];
      const int j = targets_.parameter[complex_.vertex(Triangulation::Prev(h))];
      if (i == j) continue;
      const double weight = 0.5 * triangles_[Triangulation::Face(h)].Cotangent(h % 3);
      if (i != kNone) add(i, i, weight);
      if (j != kNone) add(j, j, weight);
      if (i != kNone && j != kNone) add(std::max(i, j), std::min(i, j), -weight);
    }
  };
  AssembleLower(NumParameters(), for_each_entry, lower);
  return true;
}

std::vector<int> ConformalEquivalenceEnergy::GaugeParameters() const {
  const bool held = std::find(targets_.parameter.begin(), targets_.parameter.end(), kNone) !=
                    targets_.parameter.end();
  return held || NumParameters() == 0 ? std::vector<int>{} : std::vector<int>{0};
}

}  // namespace cirque

#include "cirque/layout/beltrami_system.h"

#include <algorithm>
#include <limits>

#include "cirque/layout/step_system.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

struct Derivatives {
  Complex f_z, f_zbar;
};

/// Of differences: the hats' gradients sum to zero, the coordinates' common part need not vanish in
/// floating point.
Derivatives Measure(const BeltramiFace& face, const Eigen::VectorXcd& z) {
  const Complex origin = z[face.vertex[0]];
  const Complex first = z[face.vertex[1]] - origin, second = z[face.vertex[2]] - origin;
  return {first * std::conj(face.hat[1]) + second * std::conj(face.hat[2]),
          first * face.hat[1] + second * face.hat[2]};
}

}  // namespace

double SquaredBeltrami(const BeltramiFace& face, const Eigen::VectorXcd& z) {
  const auto [f_z, f_zbar] = Measure(face, z);
  return std::norm(f_zbar) / std::norm(f_z);
}

std::complex<double> SeamConstraint::operator()(const Eigen::VectorXcd& z) const {
  // Differences first: translations of a side then cancel without rounding.
  return factor[0] * (z[vertex[0]] - z[vertex[1]]) + factor[2] * (z[vertex[2]] - z[vertex[3]]);
}

BeltramiSystem::BeltramiSystem(const MapPart& part, const MapObjective& objective)
    : part_(part),
      objective_(objective),
      gradient_(part.unknowns),
      penalty_(static_cast<Eigen::Index>(part.seams.size())) {
  LayOutPattern();
  FindSlots();
}

double BeltramiSystem::Value(const Eigen::VectorXcd& z) const {
  double sum = 0;
  for (const BeltramiFace& face : part_.faces) {
    const double m_squared = SquaredBeltrami(face, z);
    if (!(m_squared < 1)) return std::numeric_limits<double>::infinity();
    sum += face.weight * objective_.value(m_squared);
  }
  return sum;
}

void BeltramiSystem::Linearize(const Eigen::VectorXcd& z, double shift) {
  gradient_.setZero();
  std::fill_n(lower_.valuePtr(), lower_.nonZeros(), Complex(0));
  std::vector<double> stiffness(part_.faces.size());
  for (std::size_t f = 0; f < stiffness.size(); ++f) stiffness[f] = AddFace(f, z);
  for (std::size_t c = 0; c < part_.seams.size(); ++c) {
    const SeamConstraint& seam = part_.seams[c];
    const auto beside = [&](Index face) { return face == kNone ? 0 : stiffness[face]; };
    AddPenalty(c, kSeamStiffness * std::max(beside(seam.left_face), beside(seam.right_face)));
  }
  for (Index v = 0; v < part_.unknowns; ++v) {
    Complex& diagonal = lower_.valuePtr()[lower_.outerIndexPtr()[v]];
    // A vertex that nothing depends on stays where it is.
    diagonal = diagonal.real() > 0 ? diagonal.real() * (1 + shift) : 1;
  }
}

/// Returns the largest of the entries that it adds to the diagonal.
double BeltramiSystem::AddFace(std::size_t f, const Eigen::VectorXcd& z) {
  const BeltramiFace& face = part_.faces[f];
  const auto [f_z, f_zbar] = Measure(face, z);
  const Complex inverse = std::conj(f_z) / std::norm(f_z);
  const Complex mu = f_zbar * inverse;
  const double weight = face.weight * objective_.weight(std::norm(mu));
  std::array<Complex, 3> derivative;
  for (int k = 1; k < 3; ++k) derivative[k] = (face.hat[k] - mu * std::conj(face.hat[k])) * inverse;
  derivative[0] = -derivative[1] - derivative[2];
  const std::array<int, 6>& slot = face_slots_[f];
  const auto add = [&](int at, const Complex& value) {
    if (at != kHeld) lower_.valuePtr()[at] += value;
  };
  double largest = 0;
  for (int k = 0; k < 3; ++k) {
    const double square = weight * std::norm(derivative[k]);
    largest = std::max(largest, square);
    add(slot[k], square);
    if (face.vertex[k] < part_.unknowns) {
      gradient_[face.vertex[k]] += weight * std::conj(derivative[k]) * mu;
    }
  }
  add(slot[3], weight * std::conj(derivative[1]) * derivative[0]);
  add(slot[4], weight * std::conj(derivative[2]) * derivative[0]);
  add(slot[5], weight * std::conj(derivative[2]) * derivative[1]);
  return largest;
}

void BeltramiSystem::AddPenalty(std::size_t c, double stiffness) {
  const auto& factor = part_.seams[c].factor;
  penalty_[static_cast<Eigen::Index>(c)] = stiffness;
  for (int k = 0; k < 4; ++k) {
    for (int l = 0; l < 4; ++l) {
      const int at = seam_slots_[c][4 * k + l];
      if (at != kHeld) lower_.valuePtr()[at] += stiffness * std::conj(factor[k]) * factor[l];
    }
  }
}

void BeltramiSystem::LayOutPattern() {
  std::vector<Eigen::Triplet<Complex>> entries;
  entries.reserve(3 * part_.faces.size() + 16 * part_.seams.size() + part_.unknowns);
  const auto add = [&](Index i, Index j) {
    if (i > j && i < part_.unknowns) entries.emplace_back(i, j, Complex(0));
  };
  for (Index v = 0; v < part_.unknowns; ++v) entries.emplace_back(v, v, Complex(0));
  for (const BeltramiFace& face : part_.faces) {
    add(face.vertex[1], face.vertex[0]);
    add(face.vertex[2], face.vertex[0]);
    add(face.vertex[2], face.vertex[1]);
  }
  for (const SeamConstraint& seam : part_.seams) {
    for (const Index i : seam.vertex) {
      for (const Index j : seam.vertex) add(i, j);
    }
  }
  lower_.resize(part_.unknowns, part_.unknowns);
  lower_.setFromTriplets(entries.begin(), entries.end());
}

int BeltramiSystem::Slot(Index i, Index j) const {
  if (i < j || i >= part_.unknowns) return kHeld;
  const int* begin = lower_.innerIndexPtr() + lower_.outerIndexPtr()[j];
  const int* end = lower_.innerIndexPtr() + lower_.outerIndexPtr()[j + 1];
  return static_cast<int>(std::lower_bound(begin, end, i) - lower_.innerIndexPtr());
}

void BeltramiSystem::FindSlots() {
  face_slots_.reserve(part_.faces.size());
  for (const BeltramiFace& face : part_.faces) {
    const auto [a, b, c] = face.vertex;
    face_slots_.push_back({Slot(a, a), Slot(b, b), Slot(c, c), Slot(b, a), Slot(c, a), Slot(c, b)});
  }
  for (const SeamConstraint& seam : part_.seams) {
    std::array<int, 16>& slots = seam_slots_.emplace_back();
    for (int k = 0; k < 4; ++k) {
      for (int l = 0; l < 4; ++l) slots[4 * k + l] = Slot(seam.vertex[k], seam.vertex[l]);
    }
  }
}

}  // namespace cirque

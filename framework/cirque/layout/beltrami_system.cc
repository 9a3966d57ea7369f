#include "cirque/layout/beltrami_system.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cirque {

std::complex<double> SeamConstraint::operator()(const Eigen::VectorXcd& z) const {
  // Differences first: translations of a side then cancel without rounding.
  return factor[0] * (z[vertex[0]] - z[vertex[1]]) + factor[2] * (z[vertex[2]] - z[vertex[3]]);
}

std::vector<SeamConstraint> SeamConstraints(const Triangulation& t, const Triangulation& open,
                                            const std::vector<Seam>& seams) {
  std::vector<SeamConstraint> constraints;
  for (const Seam& seam : seams) {
    const std::complex<double> rotation = std::polar(1.0, seam.rotation);
    for (const Index h : seam.halfedges) {
      const Index twin = t.twin[h];
      // The twin runs the other way: its tail lies across from h's tip.
      constraints.push_back({{open.Tail(twin), open.Tip(twin), open.Tip(h), open.Tail(h)},
                             {1.0, -1.0, -rotation, rotation},
                             Triangulation::Face(h),
                             Triangulation::Face(twin)});
    }
  }
  return constraints;
}

namespace {

constexpr double kSeamStiffness = 1e5;  ///< of a seam's constraint over that of the faces beside it
constexpr double kShift = 1e-12;        ///< relative: for translations and similarities

}  // namespace

BeltramiSystem::BeltramiSystem(const Triangulation& surface, const Triangulation& open,
                               const CornerAngles& angles, const EdgeLengths& lengths,
                               std::vector<SeamConstraint> constraints, MapObjective objective)
    : open_(open),
      constraints_(std::move(constraints)),
      objective_(std::move(objective)),
      gradient_(open.num_vertices),
      penalty_(static_cast<Eigen::Index>(constraints_.size())) {
  double total = 0;
  for (Index f = 0; f < open.num_faces(); ++f) {
    const Index h = 3 * f;
    const double sine = std::sin(angles.value[h]), across = std::sin(angles.value[h + 2]);
    const double product =
        lengths.value[surface.edge[h + 1]] * lengths.value[surface.edge[h + 2]] * sine;
    if (!(product > 0 && across > 0)) continue;
    // The face with its first edge from 0 to 1.
    const Complex apex = std::polar(std::sin(angles.value[h + 1]) / across, angles.value[h]);
    const Complex i(0, 1);
    faces_.push_back({f, product / 2, {i * (apex - 1.0), -i * apex, i}});
    total += product / 2;
  }
  for (Face& face : faces_) face.area /= total;
  LayOutPattern();
}

BeltramiSystem::Beltrami BeltramiSystem::Measure(const Face& face,
                                                 const Eigen::VectorXcd& z) const {
  const Index* vertex = &open_.vertex[3 * face.index];
  // Of differences: the hats' gradients sum to zero, the coordinates' common part need not vanish
  // in floating point.
  const Complex first = z[vertex[1]] - z[vertex[0]], second = z[vertex[2]] - z[vertex[0]];
  const Complex f_z = first * std::conj(face.hat[1]) + second * std::conj(face.hat[2]);
  return {(first * face.hat[1] + second * face.hat[2]) / f_z, f_z};
}

double BeltramiSystem::Value(const Eigen::VectorXcd& z) const {
  double sum = 0;
  for (const Face& face : faces_) {
    const double m = std::abs(Measure(face, z).mu);
    if (!(m < 1)) return std::numeric_limits<double>::infinity();
    sum += face.area * objective_.value(m);
  }
  return sum;
}

void BeltramiSystem::Linearize(const Eigen::VectorXcd& z) {
  gradient_.setZero();
  std::fill_n(lower_.valuePtr(), lower_.nonZeros(), Complex(0));
  std::vector<double> stiffness(open_.num_faces(), 0);
  for (const Face& face : faces_) {
    const auto [mu, f_z] = Measure(face, z);
    const double weight = face.area * objective_.weight(std::abs(mu));
    const Index* vertex = &open_.vertex[3 * face.index];
    std::array<Complex, 3> derivative;
    for (int k = 0; k < 3; ++k) {
      derivative[k] = (face.hat[k] - mu * std::conj(face.hat[k])) / f_z;
      gradient_[vertex[k]] += weight * std::conj(derivative[k]) * mu;
    }
    for (int k = 0; k < 3; ++k) {
      stiffness[face.index] = std::max(stiffness[face.index], weight * std::norm(derivative[k]));
      for (int l = 0; l < 3; ++l) {
        AddToLower(vertex[k], vertex[l], weight * std::conj(derivative[k]) * derivative[l]);
      }
    }
  }
  AddPenalties(stiffness);
  ShiftDiagonal();
}

void BeltramiSystem::LayOutPattern() {
  std::vector<Eigen::Triplet<Complex>> entries;
  entries.reserve(6 * faces_.size() + 10 * constraints_.size() + open_.num_vertices);
  const auto add = [&](Index i, Index j) {
    if (i >= j) entries.emplace_back(i, j, Complex(0));
  };
  for (Index v = 0; v < open_.num_vertices; ++v) add(v, v);
  for (Index h = 0; h < open_.num_halfedges(); ++h) {
    add(open_.Tail(h), open_.Tip(h));
    add(open_.Tip(h), open_.Tail(h));
  }
  for (const SeamConstraint& constraint : constraints_) {
    for (const Index i : constraint.vertex) {
      for (const Index j : constraint.vertex) add(i, j);
    }
  }
  lower_.resize(open_.num_vertices, open_.num_vertices);
  lower_.setFromTriplets(entries.begin(), entries.end());
}

void BeltramiSystem::AddToLower(Index i, Index j, Complex value) {
  if (i < j) return;
  const int* begin = lower_.innerIndexPtr() + lower_.outerIndexPtr()[j];
  const int* end = lower_.innerIndexPtr() + lower_.outerIndexPtr()[j + 1];
  lower_.valuePtr()[std::lower_bound(begin, end, i) - lower_.innerIndexPtr()] += value;
}

void BeltramiSystem::AddPenalties(const std::vector<double>& stiffness) {
  for (std::size_t c = 0; c < constraints_.size(); ++c) {
    const SeamConstraint& constraint = constraints_[c];
    const double beside =
        std::max(stiffness[constraint.left_face], stiffness[constraint.right_face]);
    penalty_[static_cast<Eigen::Index>(c)] = kSeamStiffness * beside;
    for (int k = 0; k < 4; ++k) {
      for (int l = 0; l < 4; ++l) {
        AddToLower(
            constraint.vertex[k], constraint.vertex[l],
            kSeamStiffness * beside * std::conj(constraint.factor[k]) * constraint.factor[l]);
      }
    }
  }
}

void BeltramiSystem::ShiftDiagonal() {
  const double least = lower_.diagonal().cwiseAbs().mean();
  for (Index v = 0; v < open_.num_vertices; ++v) {
    Complex& diagonal = lower_.valuePtr()[lower_.outerIndexPtr()[v]];
    diagonal = diagonal.real() * (1 + kShift) + kShift * least;
  }
}

}  // namespace cirque

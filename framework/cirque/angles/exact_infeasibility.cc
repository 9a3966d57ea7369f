#include <algorithm>
#include <cmath>
#include <vector>

#include "cirque/angles/infeasibility.h"
#include "cirque/math/exact_integer.h"

namespace cirque {
namespace {

/// Every finite double is a multiple of 2^-1074; a product of two is one of 2^-2148.
constexpr int kFractionBits = 1074;

/// x in units of 2^-1074.
ExactInteger Exact(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);  // x = fraction 2^exponent
  auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  int shift = exponent - 53 + kFractionBits;
  // A subnormal: its last bits are zero, so that the division is exact.
  for (; shift < 0; ++shift) mantissa /= 2;
  return ExactInteger(mantissa, shift);
}

bool AllFinite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

bool IsWellFormed(const Triangulation& t, const InfeasibilityCertificate& certificate) {
  const std::size_t constrained = certificate.constrained_vertex.size();
  return certificate.epsilon_over_pi >= 0 && 3 * certificate.epsilon_over_pi < 1 &&
         static_cast<Index>(certificate.face_multiplier.size()) == t.num_faces() &&
         certificate.vertex_multiplier.size() == constrained &&
         certificate.lower_over_pi.size() == constrained &&
         certificate.upper_over_pi.size() == constrained &&
         AllFinite(certificate.face_multiplier) && AllFinite(certificate.vertex_multiplier) &&
         AllFinite(certificate.lower_over_pi) && AllFinite(certificate.upper_over_pi);
}

/// sum_e max over Q_e of p a_l + q a_r, from its parts: at a corner of Q_e it is
///   eps (p + q) + (1 - 3 eps) max(0, p, q), at a boundary edge eps p + (1 - 2 eps) max(0, p).
struct SupportParts {
  ExactInteger sum, interior, boundary;  ///< in units of 2^-1074
  bool some_nonzero = false;
};

SupportParts SumSupports(const Triangulation& t, const InfeasibilityCertificate& certificate) {
  std::vector<double> of_vertex(t.num_vertices, 0.0);
  for (std::size_t i = 0; i < certificate.constrained_vertex.size(); ++i) {
    of_vertex[certificate.constrained_vertex[i]] = certificate.vertex_multiplier[i];
  }
  const auto slope = [&](Index h) {
    return Exact(certificate.face_multiplier[Triangulation::Face(h)]) +
           Exact(of_vertex[t.vertex[h]]);
  };
  SupportParts parts;
  for (const Index l : t.edge_halfedge) {
    const ExactInteger p = slope(l);
    parts.sum = parts.sum + p;
    parts.some_nonzero = parts.some_nonzero || p.Sign() != 0;
    if (t.twin[l] == kNone) {
      if (p.Sign() > 0) parts.boundary = parts.boundary + p;
      continue;
    }
    const ExactInteger q = slope(t.twin[l]);
    parts.sum = parts.sum + q;
    parts.some_nonzero = parts.some_nonzero || q.Sign() != 0;
    const ExactInteger& larger = (p - q).Sign() > 0 ? p : q;
    if (larger.Sign() > 0) parts.interior = parts.interior + larger;
  }
  return parts;
}

/// The left side in units of 2^-2148.
ExactInteger LeftSide(const InfeasibilityCertificate& certificate) {
  ExactInteger of_faces, left;
  for (const double y : certificate.face_multiplier) of_faces = of_faces + Exact(y);
  left = of_faces * ExactInteger(1, kFractionBits);
  for (std::size_t i = 0; i < certificate.vertex_multiplier.size(); ++i) {
    const double y = certificate.vertex_multiplier[i];
    left = left +
           Exact(y) * Exact(y > 0 ? certificate.lower_over_pi[i] : certificate.upper_over_pi[i]);
  }
  return left;
}

}  // namespace

bool HoldsExactly(const Triangulation& triangulation, const InfeasibilityCertificate& certificate) {
  if (!IsWellFormed(triangulation, certificate)) return false;
  const SupportParts parts = SumSupports(triangulation, certificate);
  const ExactInteger one(1, kFractionBits), epsilon = Exact(certificate.epsilon_over_pi);
  const ExactInteger right = epsilon * parts.sum +
                             (one - ExactInteger(3, 0) * epsilon) * parts.interior +
                             (one - ExactInteger(2, 0) * epsilon) * parts.boundary;
  const int sign = (LeftSide(certificate) - right).Sign();
  return sign > 0 || (sign == 0 && certificate.epsilon_over_pi == 0 && parts.some_nonzero);
}

}  // namespace cirque

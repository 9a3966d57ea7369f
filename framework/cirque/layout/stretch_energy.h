#pragma once

#include "cirque/core/registry.h"

namespace cirque {

/// An energy of one face with its derivatives. The map's differential on the face is
/// df = a dz + b dzbar, so that of s = |a| + |b| >= t = |a| - |b|, its singular values, an energy
/// that turns of surface and plane do not change is a function of
///   p = |a|^2 = (s + t)^2 / 4,   r = |b|^2 = (s - t)^2 / 4,
/// smooth also where s = t. det = s t = p - r, and s^2 + t^2 = 2 (p + r).
struct StretchTerms {
  double value;
  double p, r;        ///< first derivatives
  double pp, pr, rr;  ///< second
};

/// What a refinement of a map lowers that is to keep lengths or areas, not angles alone: the
/// area-weighted mean over the faces of a function of both singular values. 0 is its least value.
struct StretchEnergy {
  StretchTerms (*terms)(double p, double r, double weight);  ///< @pre p > r >= 0
  bool blends = false;                                       ///< reads the weight
  double weight = 0.5;                                       ///< in [0, 1]
};

/// With s and t for a surface in its own unit (BestUnit):
///
///   symmetric_dirichlet  1/2 (s^2 + t^2 + 1/s^2 + 1/t^2) - 2: 0 for an isometry, infinite where a
///                        face collapses or is torn to infinite length (J. Smith, S. Schaefer,
///                        "Bijective parameterization with free boundaries", ACM TOG 34(4), 2015;
///                        what M. Rabinovich, R. Poranne, D. Panozzo, O. Sorkine-Hornung, "Scalable
///                        locally injective mappings", ACM TOG 36(2), 2017, lower by default);
///   arap                 (s - 1)^2 + (t - 1)^2, as rigid as possible (L. Liu, L. Zhang, Y. Xu,
///                        C. Gotsman, S. Gortler, "A local/global approach to mesh
///                        parameterization", SGP 2008), whose minimum may flip faces; so with a
///                        hundredth of symmetric_dirichlet, which no face that collapses can pay;
///   area                 (1 - weight) (s/t + t/s - 2) + weight (st + 1/(st) - 2): from `mips` at
///                        weight 0 to area alone at 1. At 1/2 it is half of symmetric_dirichlet, to
///                        second order about an isometry. (M. Corman, K. Crane, "Rectangular surface
///                        parameterization", ACM TOG 44(4), 2025, have one such number for seamless
///                        maps.)
const Registry<StretchEnergy>& StretchEnergies();

}  // namespace cirque

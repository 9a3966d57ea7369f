#pragma once

#include "cirque/math/scalar_jet.h"

namespace cirque {

/// Divergences of an angle from its reference, t = alpha / alpha0 > 0. Both are convex, nonnegative
/// and vanish at t = 1 only, and both come as an exact least-squares residual
/// r(t) = sign(t - 1) sqrt(2 D(t)), smooth and increasing also at t = 1, where dr/dt = 1.
/// Values, derivatives and residuals have relative errors of a few 1e-15, near t = 1 too,
/// for t from 1e-150 to 1e150 (beyond, squares leave the range of doubles).
/// Values at t = 0 are the limits (a residual has no derivative there); t < 0 is outside the domain
/// and gives NaN.

/// Itakura-Saito: IS(t) = t - log t - 1, infinite at 0; slope 1 - 1/t, curvature 1/t^2.
/// Source: F. Itakura, S. Saito, Analysis synthesis telephony based on the maximum likelihood
/// method, 6th Int. Congress on Acoustics (1968).
ScalarJet ItakuraSaito(double t);

/// r(t) = (t-1) - (t-1)^2/3 + 7 (t-1)^3/36 - ... near 1.
ResidualJet ItakuraSaitoResidual(double t);

/// Kullback-Leibler of positive measures: KL(t) = t log t - t + 1 = t IS(1/t), 1 at 0; slope log t,
/// curvature 1/t.
/// Source: S. Kullback, R. A. Leibler, On information and sufficiency, Ann. Math. Stat. 22 (1951).
ScalarJet KullbackLeibler(double t);

/// r(t) = (t-1) - (t-1)^2/6 + 5 (t-1)^3/72 - ... near 1.
ResidualJet KullbackLeiblerResidual(double t);

}  // namespace cirque

#pragma once

#include "cirque/core/registry.h"

namespace cirque {

/// What a refinement of a map lowers: the area-weighted mean over the faces of a function of
/// m = |mu| in [0, 1), mu = f_zbar / f_z the Beltrami coefficient of the map on the face. The ratio
/// of the singular values there is (1 + m) / (1 - m). Both functions take m^2, which needs no root.
struct MapObjective {
  double (*value)(double m_squared);   ///< 0 at 0, increasing, infinite at 1
  double (*weight)(double m_squared);  ///< dvalue/dm / m, finite and positive also at 0
};

/// With q the ratio of the singular values:
///
///   mips               q + 1/q - 2 = 4 m^2 / (1 - m^2) (K. Hormann, G. Greiner, "MIPS: an
///                      efficient global parametrization method", 2000): smooth, and hard on the
///                      worst triangles;
///   quasi_conformal    q - 1 = 2 m / (1 - m), whose mean is what programs are compared by; rounded
///                      off below m = 1e-4. It converges slowly, and lets single triangles go.
const Registry<MapObjective>& MapObjectives();

}  // namespace cirque

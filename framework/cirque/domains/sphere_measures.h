#pragma once

#include <Eigen/Core>

#include "cirque/core/infeasibility.h"
#include "cirque/domains/domain.h"
#include "cirque/mesh/holes.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// The smallest intersection angle of circumcircles on the sphere [rad], from the flat angles of
/// the punctured triangulation: across edges of the plane, on the link between a circle and a line,
/// at the pole between two lines.
double SphericalDelaunayMargin(const IntrinsicSurface& punctured,
                               const Eigen::VectorXd& flat_angles);

/// The proof for the punctured surface in the numbers of the input file, its faces those of the
/// whole surface.
void NumberAsInFile(const Surface& surface, const PuncturedSurface& punctured,
                    InfeasibilityCertificate* proof);

/// Fills in the map's distortions and their figures in the certificate, whose sphere there is already.
void MeasureSphereMap(const Surface& surface, const EdgeLengths& lengths, SurfaceMap* map);

}  // namespace cirque

#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/infeasibility.h"
#include "cirque/domains/domain.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/mesh/holes.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// Up to `count` vertices that suit as pole of a sphere map, the best first, the others far from it
/// and from each other.
///
/// The inversion x -> (x - p)/|x - p|^2 of space about the pole p is conformal, and makes of the
/// surface the one whose angles the plane is to have (InvertedLengths). It distorts triangles
/// according to their size over their distance from p. Candidates are the vertices with the largest
/// and best shaped stars (area times smallest angle, in the intrinsic triangulation); among them
/// the best has the least
///   sum over edges ij not at p of length_ij^2 / (|x_i - p| |x_j - p|),
/// which is large where the mesh is coarse around p (few triangles between it and the rest), on
/// tips of limbs, and in thin sheets, whose other side is near.
std::vector<Index> PoleCandidates(const Surface& surface, const IntrinsicTriangulation& intrinsic,
                                  Index count);

/// By what power of e the log radii of a map with this pole would range, as the linear model predicts:
/// the range of u, away from the pole, with
///   L u = 4 pi delta_pole - K,
/// L the cotangent Laplacian and K the curvatures (ConeProblem).
double PredictedLogRange(const IntrinsicTriangulation& intrinsic, Index pole);

/// The edge lengths of the punctured triangulation after the inversion of space about the pole:
/// length_ij / (|x_i - p| |x_j - p|), in units of 1/diameter. For a mesh with its vertices on a
/// sphere these are the lengths of its stereographic projection. `lengths` are of the closed
/// triangulation that was punctured.
EdgeLengths InvertedLengths(const Surface& surface, const Triangulation& closed,
                            const EdgeLengths& lengths, const PuncturedSurface& punctured);

/// The smallest intersection angle of circumcircles on the sphere [rad], from the flat angles of
/// the punctured triangulation: across edges of the plane, on the link between a circle and a line,
/// at the pole between two lines.
double SphericalDelaunayMargin(const IntrinsicSurface& punctured,
                               const Eigen::VectorXd& flat_angles);

/// The proof for the punctured surface in the numbers of the input file, its faces those of the
/// whole surface.
void NumberAsInFile(const Surface& surface, const PuncturedSurface& punctured,
                    InfeasibilityCertificate* proof);

/// Fills in the map's distortions and their figures in the certificate, whose sphere there is
/// already.
void MeasureSphereMap(const Surface& surface, const EdgeLengths& lengths, SurfaceMap* map);

}  // namespace cirque

#pragma once

#include <atomic>
#include <vector>

#include <Eigen/Core>

#include "cirque/layout/collapsed_map.h"

namespace cirque {

/// Lowers the mips energy of a map (MapObjectives) by nonlinear Gauss-Seidel sweeps: every vertex in
/// turn makes the Gauss-Newton step of its star alone,
///   dz = - omega sum_f A_f w_f conj(J_f) mu_f / sum_f A_f w_f |J_f|^2,   J_f = d mu_f / d z,
/// with mu_f the Beltrami coefficient, w_f the objective's weight and A_f the area on the surface of
/// a face of the star, halved until it lowers the star's energy and keeps every triangle
/// counter-clockwise, exactly. Overrelaxed (omega > 1: successive overrelaxation). A sweep takes
/// away what of the distortion changes from vertex to vertex; swept at every level on the way from a
/// coarse mesh to a fine one, all of it goes (cascadic multigrid: F. Bornemann, P. Deuflhard 1996).
///
/// All images of a vertex on the cut move as one, each by the motions between the sides of the cut
/// around it, so that the sides stay as similar as they are. Where these do not lead back to the
/// first image, at cones, the vertex stays. Vertices of one colour move at once: the result does not
/// depend on threads. Ends early, between sweeps, where `cancelled`.
/// @pre all faces that are there are counter-clockwise.
void RelaxMap(const std::vector<Eigen::Vector3d>& position, int sweeps,
              const std::atomic<bool>* cancelled, CollapsedMap* map);

}  // namespace cirque

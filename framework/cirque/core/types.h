#pragma once

#include <cstdint>
#include <numbers>

/// Notation, everywhere in Cirque (all angles in radians unless a name says otherwise):
///   f, v, e, h   face, vertex, edge, halfedge; F, V, E: how many there are
///   alpha        corner angle of a triangle; alpha_l, alpha_r: the two opposite an interior edge
///   theta        intersection angle of the circumcircles at an edge:
///                pi - alpha_l - alpha_r inside, pi - alpha on the boundary
///   theta*       pi - theta
///   rho          log radius: natural logarithm of the circumradius of a face
///   d            rho_i - rho_j across an edge
///   phi          half of the angle under which face i sees the edge from its circumcentre
///   Theta        angle sum at a vertex: the cone angle at an interior one
///   eps          the least corner angle and the least intersection angle that a fit may return
namespace cirque {

/// Index of a face, vertex, edge or halfedge. 32 bits carry 700 million triangles.
using Index = std::int32_t;

/// "No such element": the twin of a boundary halfedge, for instance.
inline constexpr Index kNone = -1;

/// Half a turn [rad].
inline constexpr double kPi = std::numbers::pi;

}  // namespace cirque

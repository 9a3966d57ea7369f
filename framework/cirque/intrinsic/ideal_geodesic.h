#pragma once

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/overlay.h"

namespace cirque {

/// The crossings of an edge of the surface with edges of the triangulation that Ptolemy flips and
/// scales made of it, in the hyperbolic metric that both have in common: every Euclidean triangle is
/// an ideal one in Klein's model in its circumcircle, edges are geodesics. What lies at x between the
/// vertices of a triangle is, with the light-like vectors v_i whose products -2 <v_i, v_j> are the
/// squared lengths, the point on sum x_i v_i; scales turn v_i into e^(u_i) v_i. So vertices are
/// joined by planes, and the map between the metrics is projective on every piece, continuous across
/// edges. (B. Springborn, P. Schroeder, U. Pinkall, "Conformal equivalence of triangle meshes", ACM
/// TOG 27(3), 2008; M. Gillespie, B. Springborn, K. Crane, "Discrete conformal equivalence of
/// polyhedral surfaces", ACM TOG 40(4), 2021.) Across an edge a b with the vertices c and d beside it
///   d = ((|db|^2 + g |bc|^2) a + (|da|^2 + g |ca|^2) b) / |ab|^2 - g c,  g = |da| |db| / |bc| |ca|.
///
/// So at every vertex and crossing the map has a weight w, as homogeneous coordinates have: the point of
/// the surface's plane there, whose coordinates add up to 1, is w times that of the scaled plane;
/// e^(-u_i) at a vertex. Between points whose images are z_k the map takes sum x_k p_k to
/// sum x_k w_k z_k / sum x_k w_k.
///
/// `lengths` are the scaled ones of `triangulation`, which need not be triangles, `log_scale` u (V)
/// what they were scaled with. Where scales differ by more than doubles hold, crossings are put to an
/// end of the edge.
PathPositions TraceIdealGeodesic(const Triangulation& triangulation, const EdgeLengths& lengths,
                                 const Eigen::VectorXd& log_scale, const EdgePath& path);

/// The same as the rule of an overlay. An edge of the input that flips in the surface's own metric
/// took away is drawn as the geodesic that it can be pulled to, too. All must outlive the rule.
PositionRule IdealGeodesics(const Triangulation& triangulation, const EdgeLengths& lengths,
                            const Eigen::VectorXd& log_scale);

}  // namespace cirque

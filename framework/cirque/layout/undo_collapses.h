#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/status.h"
#include "cirque/core/types.h"
#include "cirque/layout/collapsed_map.h"
#include "cirque/mesh/coarsen.h"

namespace cirque {

/// Undoes the last `count` collapses of a log, and takes them off it: in reverse order every vertex
/// comes back where the triangles of its star are least distorted, in the sense of least squares,
///   min_z  sum_f A_f |f_zbar|^2     (B. Levy, S. Petitjean, N. Ray, J. Maillot 2002),
/// or, where some of them would not be counter-clockwise there, as near to that as the kernel of its
/// ring allows on the way from within. A kernel there is: the triangles at the vertex that it was
/// collapsed to are counter-clockwise, so just beside that, within the two outermost sides, all of
/// the star is. Orientations are exact. So a map without flipped triangles stays one.
///
/// A cut edge within the ring then leads through the vertex: it is homotopic to the one before, and
/// opens the surface as that did. The star is unrolled across such edges, the vertex is placed
/// in the first triangle's frame, and has an image in each other frame by the motions between them:
/// both sides of an edge that is cut stay as similar as they were.
///
/// `position`: of all vertices in space. Returns how many had to keep off their own best place.
/// Error (unrepresentable): doubles hold no point of a kernel.
/// @pre all faces that are there are counter-clockwise.
StatusOr<Index> UndoCollapses(const std::vector<Eigen::Vector3d>& position, std::size_t count,
                              CollapseLog* log, CollapsedMap* map);

}  // namespace cirque

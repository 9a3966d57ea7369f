#pragma once

#include "cirque/metrics/distortion_measure.h"

namespace cirque {

/// How much of the plane the image covers more than once, for the image scaled so that its
/// triangles have total area 1, flipped ones included: `overlap_area` is 1 minus the area of their
/// union, the overlap area of L. Shay, J. Solomon, O. Stein, A dataset and benchmark for mesh
/// parameterization, 2022; `covered_twice_area` the area of the points that two triangles or more
/// cover. Both agree where nothing is covered three times.
///
/// Pairs are found through a tree of boxes, and whether two triangles overlap is decided exactly,
/// so a map without overlaps measures exactly 0. From the largest triangle down, each is cut into
/// convex pieces by the larger ones that it overlaps; their areas are right to about 1e-12.
/// O(n log n) and the pieces, whose number the order keeps in proportion to the overlaps.
DistortionMeasure Overlap();

}  // namespace cirque

#pragma once

#include "cirque/metrics/distortion_measure.h"

/// The distortion measures that registry.cc names. In their formulas, of every measurable face,
///
///   s >= t > 0   singular values of the map's differential, positive where it is flipped, too;
///   A, a         areas on the surface and in the plane, each of total 1 over all faces;
///   mean         over the faces, weighted by A; so are percentiles.
///
/// [SSS] is L. Shay, J. Solomon, O. Stein, "A dataset and benchmark for mesh parameterization",
/// 2022; [BFF] R. Sawhney, K. Crane, "Boundary first flattening", ACM TOG 37(1), 2018.
namespace cirque {

/// s / t, >= 1, and 1 everywhere for a conformal map: mean, median, 95th and 99th percentile,
/// maximum. (P. Sander, J. Snyder, S. Gortler, H. Hoppe, "Texture mapping progressive meshes",
/// SIGGRAPH 2001, name the singular values; the ratio is what the programs of [BFF] report.)
DistortionMeasure QuasiConformal();

/// |angle in the plane - angle on the surface| [rad], of every face its mean over the three
/// corners: the mean, and the maximum over all corners. Three times the mean,
///   sum A sum |difference|,
/// is the average angle discrepancy of [SSS] (who count 2 pi for each corner of a face with a side
/// of length zero; here such faces are left out).
DistortionMeasure AngleError();

/// s/t + t/s - 2: 0 for a conformal map. The maximum is the maximum angle distortion of [SSS].
DistortionMeasure AngleDistortion();

/// log(a / A): twice the log scale factor, the 2u of [BFF]. Minimum, maximum, mean and root mean
/// square.
DistortionMeasure LogAreaRatio();

/// The log conformal factor
///   u = 1/2 log(a / A) - c,   c such that the mean of u is zero,
/// which is the scale of the image that makes the L2 norm least. The maximum of |u| and the L2 norm
/// sqrt(sum A u^2), as Y. Soliman, D. Slepcev, K. Crane, "Optimal cone singularities for conformal
/// flattening", ACM TOG 37(4), 2018, and Q. Fang, W. Ouyang, M. Li, L. Liu, X.-M. Fu, "Computing
/// sparse cones with bounded distortion for conformal parameterizations", ACM TOG 40(6), 2021,
/// measure the area distortion that cones leave.
DistortionMeasure LogScale();

/// a/A + A/a - 2: 0 for an area-preserving map. The maximum is the maximum area distortion of
/// [SSS].
DistortionMeasure AreaDistortion();

/// |a - A| / A. Its mean, sum |a - A|, between 0 and 2, is the average area discrepancy of [SSS].
DistortionMeasure AreaDiscrepancy();

/// 1/2 (s^2 + t^2 + 1/s^2 + 1/t^2): 2 for an isometry, more otherwise. Mean and maximum.
/// (J. Smith, S. Schaefer, "Bijective parameterization with free boundaries", ACM TOG 34(4), 2015,
/// without the 1/2; with it: [SSS].)
DistortionMeasure SymmetricDirichlet();

/// t and s, and the least t and the greatest s of all faces, as in [SSS].
DistortionMeasure SmallerSingularValue();
DistortionMeasure LargerSingularValue();

/// How many pixels the side of a square texture needs, that holds the image, so that every face has
/// at least one pixel per unit of length in every direction: 1 / t of every face for the image
/// scaled to the unit square (by its larger extent along the axes) and the surface scaled to area
/// 1. `resolution` is the maximum for the surface as it is, the measure of [SSS]; it grows with the
/// surface. `resolution_unit_area` is the maximum of the face values.
DistortionMeasure Resolution();

/// The length on the surface, scaled to area 1, of the edges along which the map is torn: inner
/// edges whose ends have different UVs on their two sides, compared by value, each counted once
/// [SSS].
DistortionMeasure CutLength();

/// 1 for every face that is clockwise in the plane, by an exact predicate, else 0. With their share
/// p among the measurable faces, min(p, 1 - p): a map that is mirrored throughout counts as none
/// flipped [SSS].
DistortionMeasure Flipped();

/// How much of the plane the image covers more than once, for the image scaled so that its
/// triangles have total area 1, flipped ones included: `overlap_area` is 1 minus the area of their
/// union, the overlap area of [SSS]; `covered_twice_area` the area of the points that two triangles
/// or more cover. Both agree where nothing is covered three times.
///
/// Pairs are found through a tree of boxes, and whether two triangles overlap is decided exactly,
/// so a map without overlaps measures exactly 0. From the largest triangle down, each is cut into
/// convex pieces by the larger ones that it overlaps; their areas are right to about 1e-12.
/// O(n log n) and the pieces, whose number the order keeps in proportion to the overlaps.
DistortionMeasure Overlap();

/// The number of degenerate faces, which MappedFaces and with it all other figures leave out.
DistortionMeasure Degenerate();

}  // namespace cirque

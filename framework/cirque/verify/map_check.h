#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/verify/angle_check.h"
#include "cirque/verify/boundary_check.h"
#include "cirque/verify/correspondence.h"
#include "cirque/verify/overlap_check.h"

namespace cirque::verify {

struct VerifyOptions {
  double position_tolerance = 1e-6;  ///< a vertex may be off by this fraction of the bounding box
  double angle_tolerance = 1e-6;  ///< radians: a seam vertex off 2 pi by more is a cone, a vertex
                                  ///< off its target by more is an error
  double seam_tolerance = 1e-6;   ///< relative; enters with require_rigid_seams
  bool unit_disk = false;  ///< the boundary must lie on the unit circle, once round and in order
  double circle_tolerance = 1e-14;
  bool require_injective = false;              ///< an overlap makes the map invalid
  bool require_rigid_seams = false;            ///< so does a seam whose two sides differ in length
  std::vector<std::optional<double>> targets;  ///< angle sums, one per vertex; empty: none
};

/// What a caller may say of a map beside the verdict, which never depends on it.
struct QualityFigures {
  std::string lines;                                   ///< for people
  std::vector<std::pair<std::string, double>> values;  ///< by name, for programs
  Index worst_triangle = kNone;  ///< of the largest quasi-conformal distortion
};

/// What was found. Triangles are IN's fan triangles, vertices IN's, numbered from 0. A part that
/// could not be judged, because an error before it left nothing to judge, is absent.
struct MapReport {
  std::vector<std::string> errors;  ///< why the map is invalid; empty for a valid one
  Index num_triangles = 0;
  Index num_vertices = 0;
  Displacement displacement;
  Correspondence correspondence;
  std::vector<Index> turned;      ///< triangles that OUT orients against their neighbours
  std::vector<Index> without_uv;  ///< triangles that lack a UV
  std::vector<Index> not_finite;  ///< triangles with a NaN or an infinite UV
  Index num_patches = 0;
  std::optional<Orientations> orientations;
  std::optional<AngleMeasures> angles;
  std::optional<SeamAgreement> seams;
  std::optional<DiskFit> disk;            ///< with unit_disk
  std::optional<OverlapResult> overlap;   ///< judged for locally injective maps only
  std::optional<UvComplex> complex;       ///< the map as it was judged, in IN's order
  std::optional<QualityFigures> quality;  ///< left for the caller to fill

  bool valid() const { return errors.empty(); }
  /// "valid (injective)", "valid (locally injective, boundary overlaps itself)" or
  /// "INVALID: " and the errors.
  std::string Verdict() const;
};

/// Judges the map that OUT's texture coordinates are of the surface IN. A wrong map is a report
/// with errors; a status is returned when IN itself cannot be mapped (no faces, not an orientable
/// manifold, coordinates that are not finite) or a tolerance is negative or NaN.
StatusOr<MapReport> VerifyMap(const PolygonSoup& in, const PolygonSoup& out,
                              const VerifyOptions& options);

/// A few aligned lines; the last is "verdict: ...".
std::string ToText(const MapReport& report);

/// The same as one JSON object with stable snake_case keys; a number that is not known is null.
std::string ToJson(const MapReport& report);

}  // namespace cirque::verify

#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/verify/angle_check.h"
#include "cirque/verify/angle_targets.h"
#include "cirque/verify/disk_check.h"
#include "cirque/verify/judged_mesh.h"
#include "cirque/verify/mesh_match.h"
#include "cirque/verify/overlap_check.h"
#include "cirque/verify/seam_check.h"

namespace cirque::verify {

struct VerifyOptions {
  double position_tolerance = 1e-6;  ///< a vertex may be off by this fraction of the bounding box
  double angle_tolerance = 1e-6;  ///< radians: a seam vertex off 2 pi by more is a cone, a vertex
                                  ///< off its target by more is an error
  bool unit_disk = false;    ///< the boundary must lie on the unit circle, once round and in order
  bool round_holes = false;  ///< and all other loops on circles
  double circle_tolerance = 1e-14;
  double hole_tolerance = 1e-12;   ///< of the circles of holes, which are known by three vertices
  bool require_injective = false;  ///< an overlap makes the map invalid
  SeamLimits seams;                ///< so does a seam beyond these
  AngleTargets targets;            ///< angle sums; empty: none is asked for
};

/// What a caller may say of a map beside the verdict, which never depends on it.
struct QualityFigures {
  std::string lines;                                   ///< for people
  std::vector<std::pair<std::string, double>> values;  ///< by name, for programs
  Index worst_triangle = kNone;  ///< IN's face with the largest quasi-conformal distortion
};

/// What was found. Faces and vertices are IN's, numbered from 0. A part that could not be judged,
/// because an error before it left nothing to judge, is absent.
struct MapReport {
  std::vector<std::string> errors;  ///< why the map is invalid; empty for a valid one
  std::string noun = "triangle";    ///< what the faces are called: "face" where some are polygons
  Index num_faces = 0;
  Index num_triangles = 0;  ///< that the faces can be cut into
  Index num_vertices = 0;
  MeshMatch match;
  std::vector<Index> turned;      ///< faces that run against their neighbours in IN
  std::vector<Index> set_aside;   ///< faces left out of all that follows (set_aside.h)
  Index num_split = 0;            ///< vertices added where IN touches itself
  std::vector<Index> without_uv;  ///< faces that lack a UV
  std::vector<Index> not_finite;  ///< faces with a NaN or an infinite UV
  std::optional<Orientations> orientations;
  std::optional<AngleMeasures> angles;
  std::optional<SeamAgreement> seams;
  std::optional<DiskFit> disk;            ///< with unit_disk
  std::optional<HoleFit> holes;           ///< with round_holes
  std::optional<OverlapResult> overlap;   ///< judged where no face is turned over or folded
  std::optional<UvComplex> complex;       ///< the map as it was judged, in IN's order
  std::optional<QualityFigures> quality;  ///< left for the caller to fill

  bool valid() const { return errors.empty(); }
  /// "valid (injective)" or "valid (locally injective, boundary overlaps itself)" and the patches
  /// and seams, or "INVALID: " and the errors.
  std::string Verdict() const;
};

/// Judges the map that OUT's texture coordinates are of the surface IN. Its faces are found by
/// their corners (mesh_match.h), and their orientation in IN is the one that counts; OUT may have
/// IN's polygons cut up. Polygons are judged as such: the image of one must be a simple polygon of
/// the right orientation, or one that touches itself only where IN's does, at a vertex that it has
/// twice. IN may be in several components, each of which agrees with itself; edges of three faces or
/// more are taken for open, each fan of faces at a vertex for one with a vertex of its own
/// (BuildSurface), and what has no area, or is there twice, for set aside (set_aside.h). A wrong map
/// is a report with errors; a status is returned when IN itself cannot be mapped (no faces, not
/// orientable, coordinates that are not finite) or an option makes no sense.
StatusOr<MapReport> VerifyMap(const PolygonSoup& in, const PolygonSoup& out,
                              const VerifyOptions& options);

/// A few aligned lines; the last is "verdict: ...".
std::string ToText(const MapReport& report);

/// The same as one JSON object with stable snake_case keys. Keys that speak of triangles mean faces
/// where IN has others; a number that is not known, or not finite, is left out.
std::string ToJson(const MapReport& report);

}  // namespace cirque::verify

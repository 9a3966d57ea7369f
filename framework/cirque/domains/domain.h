#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/option_table.h"
#include "cirque/core/registry.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/parameterize.h"

namespace cirque {

/// What a map onto a chosen domain is to look like. Vertices are the surface's; kNone: chosen. Each
/// domain reads its own fields (Domain::reads).
struct DomainOptions {
  Index centre = kNone;  ///< disk: inner vertex that goes to 0
  Index angle_zero =
      kNone;  ///< disk: boundary vertex that goes to (1, 0); curve: to its first point
  /// The vertex that the solve sends to infinity. disk, half-plane: of the boundary. sphere: any.
  Index pole = kNone;
  /// disk, instead of a centre: "boundary" or "area" puts a centre of mass at 0 (MapToDisk).
  /// sphere: a name of SphereNormalizations(). Empty: as the domain has it.
  std::string normalization = {};
  /// rectangle, polygon, triangle: corner vertices in the boundary's order, the surface on its left
  std::vector<Index> corners = {};
  int sides = 4;  ///< polygon without corners given: how many
  /// curve: what the boundary is put on, a file of its points or an ellipse (CurveOf).
  std::string curve = "ellipse";
  /// plane: a file of where vertices go, a line `vertex x y` each (ReadPins); empty: none.
  std::string pins = {};
  /// plane, three pins or more: how much their misses weigh against the map's energy; 0: they are met
  /// exactly or there is no map (MeetLandmarks).
  double pin_weight = 0;
  /// plane: a disk that is its own mirror image gets a map that is (MapMirrored).
  bool symmetric = false;
  /// sphere: turned so that the second moments of the surface's area on it are largest along x and
  /// smallest along z, the third moments along x and y positive. (Symmetric surfaces leave axes or
  /// signs undetermined: rounding then decides, the same way every time.)
  bool principal_axes = false;
  /// sphere: fit the flat angles to those of the surface after an inversion of space about the
  /// pole; false: to the surface's own, which distorts more (for comparisons).
  bool inversion = true;
};

/// The unit of options that are vertices.
inline constexpr char kVertexUnit[] = "vertex";

/// The table of its fields.
const OptionTable<DomainOptions>& DomainOptionTable();

/// What is to be mapped onto what, and how.
struct MapRequest : ParameterizeRequest {
  std::string domain = "plane";  ///< a name of Domains()
  DomainOptions shape = {};
  /// Polygons: where the conformal map's coordinates do not tell vertices apart, its boundary is
  /// spread out (SpreadInPolygon) instead of no map. A rung of the ladder asks for it.
  bool spread_boundary = false;
};

/// A conformal map of a surface: `uv` of its corners in the plane, or `position` of its vertices on
/// the sphere.
struct SurfaceMap : Parameterization {
  std::vector<Eigen::Vector3d> position;  ///< per vertex, |x| = 1; empty: a map to the plane
  Eigen::VectorXd angle_distortion;  ///< on the sphere, per face its largest change of an angle,
                                     ///< chordal [rad]
  Eigen::VectorXd quasi_conformal;   ///< likewise, of its flat triangle to the chordal one; 0 where
                                     ///< that has no area

  bool IsOnSphere() const { return !position.empty(); }
};

/// A shape that surfaces are mapped to: an entry of the registry.
struct Domain {
  std::string help;  ///< one line
  /// What it reads of those members of a request that not every domain reads: of MapRequest
  /// ("targets", "cut"), DomainOptions and ParameterizeOptions by their names; "metric": it needs
  /// no points, lengths will do (Parameterize).
  std::vector<std::string> reads;
  /// Members of SurfaceMap that it fills in and not every domain does: "uv", "position", "flat".
  std::vector<std::string> gives;
  /// Fills in the map as far as it comes, but for what every map has: MapSurface does that.
  Status (*map)(const Surface&, const MapRequest&, const SolveControl&, SurfaceMap*);

  bool Reads(const std::string& option) const;
  bool Gives(const std::string& member) const;
};

/// Maps a surface onto a domain: the library's one way from a surface to its map. Errors:
/// kInvalidInput (a domain, option, vertex or surface that do not fit each other), kInfeasible (the
/// certificate holds the proof), kUnrepresentable, kNotConverged, kCancelled; `failed`, unless
/// null, then receives the certificate, filled as far as the stages came.
StatusOr<SurfaceMap> MapSurface(const Surface& surface, const MapRequest& request,
                                const SolveControl& control = {}, Certificate* failed = nullptr);

/// The domains, one line each.
const Registry<Domain>& Domains();

/// The same with a table of the caller's, such as Domains().With("mine", ...).
StatusOr<SurfaceMap> MapSurface(const Surface& surface, const MapRequest& request,
                                const SolveControl& control, Certificate* failed,
                                const Registry<Domain>& domains);

/// Whether some domain reads this member of a request.
bool IsReadBySomeDomain(const std::string& option);

}  // namespace cirque

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/domains/component_requests.h"
#include "cirque/domains/domain.h"
#include "cirque/domains/map_options.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/mesh/preflight.h"
#include "cirque/mesh/surface.h"

/// From polygons to a map of all that can be mapped: what the programs, MapSurface of arrays, Python
/// and meshes of OpenMesh have in common.
namespace cirque {

/// A mesh, judged, repaired and taken apart.
struct MeshParts {
  std::vector<MeshComponent> components;  ///< in the order of their first faces
  PreflightReport report;
  RepairSummary repair;
  double seconds = 0;  ///< that it took

  bool IsOne() const { return components.size() == 1; }
  /// Those of the components that are surfaces.
  std::vector<const Surface*> Surfaces() const;
  /// "2 (12 faces from face 1 on, 8 faces from face 13 on)", for messages.
  std::string Sizes() const;
};

/// SurfacesOf, as MeshOptions::repair says. Errors: as it; what was seen stands in `parts` then too.
Status TakeApart(const PolygonSoup& soup, const std::string& repair, MeshParts* parts);

/// What came of the components.
struct MappedMesh {
  /// Ok, or the worst of the components' (SummarizeComponents), which it names where there are
  /// several. An inaccurate map is one.
  Status status;
  /// All that has a map: the component, or several, one behind the other; null: none has.
  std::shared_ptr<const Surface> surface;
  /// That with the fill of holes, which `map.exact_map` is of; without an exact map of several
  /// components the same as `surface`.
  std::shared_ptr<const Surface> solved_surface;
  /// The map of `surface`, in the frame that was asked for. Its certificate is filled in in any
  /// case, and is that of all components. Of several components it holds no cut and no flat metric.
  SurfaceMap map;
  /// What the certificate's proof of infeasibility is about; null without one.
  std::shared_ptr<const Surface> proof_surface;
  Index num_filled_loops = 0;
};

/// Maps every component by itself, the largest first, as many at once as there are threads, and lays
/// the images side by side. Results do not depend on threads. The fill of holes is no part of the
/// map, but is of its flat metric and its cut. Errors, before or instead of any map: those of the
/// request; several components where the domain takes one; holes that cannot be filled; kCancelled.
/// @pre the options are as their table lets them be.
StatusOr<MappedMesh> MapMesh(const std::shared_ptr<const MeshParts>& mesh,
                             const MeshOptions& options, const SurfaceRequest& request,
                             const SolveControl& control);

}  // namespace cirque

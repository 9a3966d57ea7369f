#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/pipeline/cone_stages.h"
#include "cirque/pipeline/flat_surface.h"
#include "cirque/pipeline/options.h"
#include "cirque/pipeline/parameterization.h"
#include "cirque/pipeline/road_keeper.h"
#include "cirque/pipeline/summaries.h"

/// The lines of the ladder: when each applies, and what it changes.
namespace cirque {

/// One road from a surface to its map: how, and for which targets.
struct Road {
  ParameterizeOptions options = {};
  std::optional<ConeTargets> targets = {};       ///< nothing: as the options place them
  std::optional<ConeRepairSummary> repair = {};  ///< what was done to the cones of a road before
  DualFit dual = DualFit::kFirst;
};

/// Where the ladder stands.
struct LadderStart {
  const ConeSite& site;
  const Road& asked;  ///< with the user's targets, if there are any
  bool cut_given = false;

  const IntrinsicSurface& surface() const { return site.surface(); }
};

/// The last road tried.
struct EndedRoad {
  const LadderStart& start;
  const Road& road;
  RoadEnd end;
  const Parameterization& map;
  const ConeTargets& asked_for;     ///< the targets of the road that was asked for
  RoadEnd asked_end;                ///< how that ended
  std::optional<int>* least_cones;  ///< of the rungs that place them, once one has asked
};

/// A line of the ladder.
struct Rung {
  const char* name;
  const char* made_with;  ///< what a map of it is made with, for people
  bool same_targets;      ///< a proof on it is one about the road that was asked for
  bool (*applies)(const EndedRoad&);
  bool (*change)(const EndedRoad&, int number, Road*);
  int number;  ///< what `change` counts
};

/// All rungs, in order.
std::span<const Rung> AllRungs();

/// The names of the rungs, in order.
std::vector<std::string> LadderRungs();

/// The one that moves four times as many cones: also for maps of little use.
const Rung& MoreConesRung();

/// Those that place cones wherever the surface is curved, the least share first: also for maps of no
/// use, the last where one before led to those.
std::span<const Rung> CurvedRungs();

/// Whether a surface has so few vertices (up to 1,000) that its triangles cannot bend and a few cones
/// unfold it.
bool IsCoarse(const IntrinsicSurface& surface);

/// Whether a road's cones are those of such a rung.
bool IsConedWhereCurved(const Road& road);

/// Whether it was a circle pattern's: rungs about angles and radii are of no use to conformal
/// equivalence.
bool ByCircles(const EndedRoad& last);

}  // namespace cirque

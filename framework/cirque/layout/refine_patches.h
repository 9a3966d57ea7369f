#pragma once

#include <atomic>

#include "cirque/core/metric.h"
#include "cirque/core/option_table.h"
#include "cirque/core/status.h"
#include "cirque/layout/refine_map.h"

namespace cirque {

/// Energies e = q + 1/q - 2 of faces, q the ratio of the map's singular values there; E their mean,
/// weighted by area with a floor.
struct RefinePatchesOptions {
  double flag = 0.5;   ///< faces of less energy are no outliers,
  double medians = 4;  ///< nor those below this many medians of all
  double area = 0.1;   ///< least weight of a face, in mean areas: needles count too
  double share = 0.3;  ///< of the vertices, that patches may hold
  int growth = 2;      ///< rings around the outliers: 1, and so many times more each round
  int rounds = 4;      ///< of patches, the most
  double round_decrease = 0.02;  ///< share of E that a round must bring for another one
  int patch_steps = 30;          ///< in a patch and a round, the most
  double patch_decrease = 0.01;  ///< share of its energy that a step in a patch must bring
  double mean = 0.01;  ///< E above which the whole map is refined too; twice that if large
  /// E above which that is at least one step, unless the map is large; with seams, unless it is small,
  /// six times that.
  double once = 5e-4;
  int steps = 30;  ///< on the whole map, the most; ten times that if small
  double decrease =
      0.01;  ///< share of E that such a step must bring; five times that if large, a hundredth if small
};

/// All by name, with their meanings, for configs and the command line.
const OptionTable<RefinePatchesOptions>& RefinePatchesOptionTable();

/// What became of the mean energy E, and where.
struct PatchRefinement : MapRefinement {
  int flagged = 0;  ///< outliers at the start
  int patches = 0;  ///< in all rounds
  int rounds = 0;
  int patch_steps = 0;  ///< in all patches
};

/// RefineMap by mips where it is worth its time. A few triangles that the angle fit left at its
/// bounds make most of the distortion of a bad map, and moving the vertices around them mends it:
/// outliers are grown by rings of neighbours to patches, whose vertices move while all others stay,
/// in parallel; the next round has wider ones around what is still an outlier. The whole map is
/// refined where the mean remains above its limit, by one step already where it is above a small one,
/// which takes a tenth or two off a good map's distortion, and at once where distortion is no matter of a
/// few triangles: patches would hold too many vertices, E by area alone is above 5, or the outliers
/// make less than half of E and the rest is above 0.03.
///
/// Errors: cancelled.
StatusOr<PatchRefinement> RefineByPatches(const SeamedSurface& of,
                                          const RefinePatchesOptions& options,
                                          const std::atomic<bool>* cancelled, CornerUv* uv);

}  // namespace cirque

#include "cirque/layout/refine_patches.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "cirque/core/grouping.h"
#include "cirque/core/parallel.h"
#include "cirque/layout/gauss_newton.h"
#include "cirque/layout/map_objective.h"

namespace cirque {
namespace {

constexpr double kWildMean = 5;          ///< of E by area alone: patches are of no use
constexpr double kScatteredMean = 0.03;  ///< of what is outside the outliers, if that is most of E
/// Where one step is to be made at least, on a map whose boundary slides: the first is cut short where
/// a circle bends away from the tangents.
constexpr int kStepsOfSliding = 3;
constexpr Index kSmallMap = 1000;  ///< faces up to which steps on the whole map cost nothing
/// Of the mean energy from which one step is made. Seams make a step dearer: rounds of multipliers, and
/// a factor with more fill.
constexpr double kOnceWithSeams = 6;
constexpr Index kLargeMap = 200000;  ///< faces from which steps on the whole map must bring more

/// A set of vertices in independent patches: no face has moving vertices of two.
struct PatchSet {
  std::vector<bool> moves;  ///< V of the opened surface
  Index vertices = 0;       ///< that move
  Index count = 0;
  std::vector<Index> of_face;  ///< F; `count` where no vertex moves
};

class PatchRefiner {
 public:
  PatchRefiner(const SeamedSurface& of, const RefinePatchesOptions& options,
               const std::atomic<bool>* cancelled, const CornerUv& uv)
      : t_(of.surface.triangulation),
        options_(options),
        cancelled_(cancelled),
        map_(of, uv, options.area) {
    Measure();
    result_.before = mean_;
  }

  void Run() {
    const std::vector<Index> outliers = Outliers();
    result_.flagged = static_cast<int>(outliers.size());
    if (!IsWild(outliers)) RefinePatches(outliers);
    RefineWhole();
    result_.after = mean_;
  }

  const PatchRefinement& result() const { return result_; }
  bool changed() const { return result_.steps + result_.patch_steps > 0; }
  void WriteTo(CornerUv* uv) const { map_.WriteTo(uv); }

 private:
  void Measure();
  std::vector<Index> Outliers() const;
  bool IsWild(const std::vector<Index>& outliers) const;
  void RefinePatches(std::vector<Index> outliers);
  PatchSet Grow(const std::vector<Index>& outliers, int rings) const;
  void GiveToPatches(const std::vector<bool>& grown, PatchSet* set) const;
  std::vector<MapPart> PartsOf(const PatchSet& set);
  void RefineOnce(const PatchSet& set);
  void RefineWhole();
  bool cancelled() const { return cancelled_ && *cancelled_; }

  const Triangulation& t_;
  const RefinePatchesOptions& options_;
  const std::atomic<bool>* cancelled_;
  const MapObjective objective_ = *MapObjectives().Find("mips");
  OpenedMap map_;
  std::vector<double> energy_;  ///< F
  double mean_ = 0;
  PatchRefinement result_;
};

void PatchRefiner::Measure() {
  energy_ = map_.Energies(objective_);
  mean_ = map_.Mean(energy_);
}

/// Faces without weight are none.
std::vector<Index> PatchRefiner::Outliers() const {
  std::vector<double> sorted = energy_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double least = std::max(options_.flag, options_.medians * *middle);
  std::vector<Index> outliers;
  for (Index f = 0; f < t_.num_faces(); ++f) {
    if (energy_[f] > least) outliers.push_back(f);
  }
  return outliers;
}

bool PatchRefiner::IsWild(const std::vector<Index>& outliers) const {
  double by_area = 0, inside = 0;
  for (Index f = 0; f < t_.num_faces(); ++f) by_area += map_.FaceArea(f) * energy_[f];
  for (const Index f : outliers) inside += map_.faces()[f].weight * energy_[f];
  return by_area > kWildMean || (inside < mean_ / 2 && mean_ - inside > kScatteredMean);
}

void PatchRefiner::RefinePatches(std::vector<Index> outliers) {
  int rings = 1;
  for (int round = 0; round < options_.rounds && !outliers.empty() && !cancelled(); ++round) {
    const PatchSet set = Grow(outliers, rings);
    if (set.vertices > options_.share * static_cast<double>(map_.open().num_vertices)) return;
    const double before = mean_;
    RefineOnce(set);
    if (mean_ > (1 - options_.round_decrease) * before) return;
    outliers = Outliers();
    rings = std::min(rings * options_.growth, t_.num_vertices);
  }
}

/// The outliers' vertices and those within `rings` edges of them, across seams too.
PatchSet PatchRefiner::Grow(const std::vector<Index>& outliers, int rings) const {
  std::vector<bool> grown(t_.num_vertices, false);
  for (const Index f : outliers) {
    for (Index c = 3 * f; c < 3 * f + 3; ++c) grown[t_.vertex[c]] = true;
  }
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<bool> before = grown;
    for (Index c = 0; c < t_.num_halfedges(); c += 3) {
      const Index* v = &t_.vertex[c];
      if (!before[v[0]] && !before[v[1]] && !before[v[2]]) continue;
      grown[v[0]] = grown[v[1]] = grown[v[2]] = true;
    }
  }
  PatchSet set;
  GiveToPatches(grown, &set);
  return set;
}

void PatchRefiner::GiveToPatches(const std::vector<bool>& grown, PatchSet* set) const {
  const Triangulation& open = map_.open();
  set->moves.assign(open.num_vertices, false);
  DisjointSets patches(t_.num_vertices);
  for (Index f = 0; f < t_.num_faces(); ++f) {
    Index first = kNone;
    for (Index c = 3 * f; c < 3 * f + 3; ++c) {
      const Index v = open.vertex[c];
      if (!grown[t_.vertex[c]] || map_.held()[v]) continue;
      set->vertices += !set->moves[v];
      set->moves[v] = true;
      if (first == kNone) first = t_.vertex[c];
      patches.Unite(first, t_.vertex[c]);
    }
  }
  std::vector<Index> number(t_.num_vertices, kNone);
  set->of_face.assign(t_.num_faces(), kNone);
  for (Index c = 0; c < t_.num_halfedges(); ++c) {
    if (!set->moves[open.vertex[c]]) continue;
    Index& patch = number[patches.Find(t_.vertex[c])];
    if (patch == kNone) patch = set->count++;
    set->of_face[Triangulation::Face(c)] = patch;
  }
  for (Index& patch : set->of_face) {
    if (patch == kNone) patch = set->count;
  }
}

/// A seam's edge moves with the faces beside it.
std::vector<MapPart> PatchRefiner::PartsOf(const PatchSet& set) {
  std::vector<Index> of_seam;
  for (const SeamConstraint& seam : map_.seams()) {
    const bool some =
        std::any_of(seam.vertex.begin(), seam.vertex.end(), [&](Index v) { return set.moves[v]; });
    of_seam.push_back(some ? set.of_face[seam.left_face] : set.count);
  }
  const Buckets faces = SortIntoBuckets(set.of_face, set.count + 1);
  const Buckets seams = SortIntoBuckets(of_seam, set.count + 1);
  const auto items = [](const Buckets& buckets, Index b) {
    return std::vector<Index>(buckets.item.begin() + buckets.first[b],
                              buckets.item.begin() + buckets.first[b + 1]);
  };
  std::vector<MapPart> parts;
  for (Index p = 0; p < set.count; ++p) {
    parts.push_back(map_.PartOf(set.moves, items(faces, p), items(seams, p)));
  }
  return parts;
}

void PatchRefiner::RefineOnce(const PatchSet& set) {
  const std::vector<MapPart> parts = PartsOf(set);
  std::vector<int> steps(parts.size(), 0);
  ParallelTasks(set.count, [&](int p) {
    steps[p] = LowerObjective(parts[p], objective_, {options_.patch_steps, options_.patch_decrease},
                              cancelled_, &map_.z());
  });
  ++result_.rounds;
  result_.patches += set.count;
  result_.patch_steps = std::accumulate(steps.begin(), steps.end(), result_.patch_steps);
  Measure();
}

void PatchRefiner::RefineWhole() {
  const bool large = t_.num_faces() > kLargeMap;
  const bool bad = mean_ > (large ? 2 : 1) * options_.mean;
  const bool small = t_.num_faces() <= kSmallMap;
  const bool dear = !small && !map_.seams().empty();
  const bool once = !large && mean_ > (dear ? kOnceWithSeams : 1) * options_.once;
  if (cancelled() || !(bad || once)) return;
  const int fewest = map_.HasRails() ? kStepsOfSliding : 1;
  const int steps = bad ? (small ? 10 : 1) * options_.steps : std::min(fewest, options_.steps);
  const double times = large ? 5 : small ? 0.01 : 1;
  const StepLimits limits = {steps, times * options_.decrease};
  result_.steps = LowerObjective(map_.Whole(), objective_, limits, cancelled_, &map_.z());
  Measure();
}

}  // namespace

const OptionTable<RefinePatchesOptions>& RefinePatchesOptionTable() {
  using O = RefinePatchesOptions;
  static const OptionTable<O> kTable(
      "auto",
      {Option<O>("flag", &O::flag, "least energy of an outlier").Between(0, 1e300),
       Option<O>("medians", &O::medians, "the same in medians").Between(0, 1e300),
       Option<O>("area", &O::area, "least weight of a face in mean areas").Between(0, 1),
       Option<O>("share", &O::share, "of the vertices that patches may hold").Between(0, 1),
       Option<O>("growth", &O::growth, "times as many rings each round").Between(1, 100),
       Option<O>("rounds", &O::rounds, "the most rounds of patches").Between(0, 100),
       Option<O>("round_decrease", &O::round_decrease, "share of the mean to go on for")
           .Between(0, 1),
       Option<O>("patch_steps", &O::patch_steps, "the most steps in a patch").Between(1, 1e6),
       Option<O>("patch_decrease", &O::patch_decrease, "share of a patch's energy to go on for")
           .Between(0, 1),
       Option<O>("mean", &O::mean, "mean energy above which the whole map is refined")
           .Between(0, 1e300),
       Option<O>("once", &O::once, "mean energy above which that is one step at least")
           .Between(0, 1e300),
       Option<O>("steps", &O::steps, "the most steps on the whole map").Between(0, 1e6),
       Option<O>("decrease", &O::decrease, "share of the mean to go on for there").Between(0, 1)});
  return kTable;
}

StatusOr<PatchRefinement> RefineByPatches(const SeamedSurface& of,
                                          const RefinePatchesOptions& options,
                                          const std::atomic<bool>* cancelled, CornerUv* uv) {
  PatchRefiner refiner(of, options, cancelled, *uv);
  refiner.Run();
  if (cancelled && *cancelled)
    return Status(StatusCode::kCancelled, "refinement of the map: interrupted");
  if (refiner.changed()) refiner.WriteTo(uv);
  return refiner.result();
}

}  // namespace cirque

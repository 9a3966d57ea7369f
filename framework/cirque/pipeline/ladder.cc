#include "cirque/pipeline/ladder.h"

#include <memory>
#include <optional>
#include <utility>

namespace cirque {
namespace {

/// Mean quasi-conformal distortion of a map of no use, and of one of little. Of a coarse surface that is
/// one, too: its few triangles cannot bend, and a few cones unfold it.
constexpr double kOfNoUse = 3, kOfLittleUse = 1.5;
constexpr double kLessDistorted = 0.5;  ///< of what it is above 1, for which longer seams are taken

/// A road taken.
struct Taken {
  Road road;
  Status status;
  RoadEnd end;
  Parameterization map;
};

class Climb {
 public:
  Climb(const LadderStart& start, const TakeARoad& take) : start_(start), take_(take) {}

  Status Run(Parameterization* result) {
    last_ = Take(start_.asked, kAsAsked);
    keeper_.Keep(last_);
    const RoadEnd first = last_->end;
    const std::shared_ptr<Taken> asked = last_;
    const bool settled = first == RoadEnd::kMap || first == RoadEnd::kStopped;
    if (!start_.asked.options.strict) {
      if (!settled) TryRungs();
      if (first != RoadEnd::kStopped) ReduceDistortion(*asked);
      if (keeper_.HasTriedOthers() || !settled) keeper_.Describe(first);
    }
    *result = std::move(keeper_.kept().map);
    return keeper_.kept().status;
  }

 private:
  std::shared_ptr<Taken> Take(const Road& road, const char* name) {
    auto taken = std::make_shared<Taken>(Taken{road, {}, RoadEnd::kStopped, {}});
    const Timer timer;
    taken->status = take_(road, &taken->map);
    taken->map.certificate.cone_repair = road.repair;
    const std::optional<AngleFitSummary>& fit = taken->map.certificate.angle_fit;
    dual_wandered_ = dual_wandered_ || (fit && fit->angle_fit_retried);
    keeper_.Note(name, timer.Seconds(), taken.get());
    return taken;
  }

  /// Takes a rung's road; null: it does not apply. One that was cancelled is kept.
  /// `where_curved`: what the dual is to do where cones leave angles near the surface's own, of which
  /// it finds those that there are.
  std::shared_ptr<Taken> TakeRung(const Rung& rung, const EndedRoad& last, DualFit where_curved) {
    Road next = last.road;
    if (!rung.applies(last) || !rung.change(last, rung.number, &next)) return nullptr;
    const DualFit elsewhere = dual_wandered_ ? DualFit::kWandered : DualFit::kFirst;
    next.dual = IsConedWhereCurved(next) ? where_curved : elsewhere;
    std::shared_ptr<Taken> taken = Take(next, rung.name);
    keeper_.CountRung();
    if (taken->status.code() == StatusCode::kCancelled) keeper_.Keep(taken);
    return taken;
  }

  /// How much the kept map is distorted where other cones may be chosen: the image of a disk that is
  /// not cut stays whole.
  double Distortion() const {
    const Taken& kept = keeper_.kept();
    const std::optional<DistortionSummary>& distortion = kept.map.certificate.distortion;
    const bool counts = kept.status.ok() && distortion && !kept.map.cut.IsEmpty() &&
                        kept.road.options.refine_map == ParameterizeOptions().refine_map;
    return counts ? distortion->quasi_conformal_mean : 1;
  }

  bool IsOfNoUse(double distortion) const {
    return distortion > (IsCoarse(start_.surface()) ? kOfLittleUse : kOfNoUse);
  }

  /// More cones instead of a map of little use, cones wherever the surface is curved instead of one of
  /// none.
  void ReduceDistortion(const Taken& asked) {
    if (Distortion() > kOfLittleUse && !IsOfNoUse(Distortion())) {
      if (!TryLessDistorted(MoreConesRung(), asked)) return;
    }
    for (const Rung& rung : CurvedRungs()) {
      if (!IsOfNoUse(Distortion())) return;
      const bool is_last = &rung == &CurvedRungs().back();
      const bool is_cut_anyway = IsConedWhereCurved(keeper_.kept().road);
      if (is_last && !is_cut_anyway) continue;
      if (!TryLessDistorted(rung, asked)) return;
    }
  }

  /// Prefers the rung's map where that is distorted half as much. False: cancelled.
  bool TryLessDistorted(const Rung& rung, const Taken& asked) {
    if (keeper_.HasTried(rung.name)) return true;
    std::optional<int> least_cones;
    const EndedRoad last{start_,    asked.road,  asked.end, asked.map, asked.map.targets,
                         asked.end, &least_cones};
    const std::shared_ptr<Taken> taken =
        ByCircles(last) ? TakeRung(rung, last, DualFit::kOrNothing) : nullptr;
    if (!taken) return true;
    if (taken->status.code() == StatusCode::kCancelled) return false;
    if (taken->end != RoadEnd::kMap) return true;
    const double mean = taken->map.certificate.distortion->quasi_conformal_mean;
    if (mean - 1 < kLessDistorted * (Distortion() - 1)) keeper_.Prefer(rung.made_with, taken);
    return true;
  }

  void TryRungs() {
    const std::shared_ptr<Taken> first = last_;
    std::optional<int> least_cones;
    for (const Rung& rung : AllRungs()) {
      const EndedRoad last{start_,     last_->road, last_->end, last_->map, first->map.targets,
                           first->end, &least_cones};
      const std::shared_ptr<Taken> taken = TakeRung(rung, last, DualFit::kFirst);
      if (!taken) continue;
      if (taken->status.code() == StatusCode::kCancelled) return;
      if (taken->end == RoadEnd::kStopped) continue;  // a heuristic that finds no cones here
      last_ = taken;
      if (keeper_.KeepBest(rung.made_with, rung.same_targets, taken)) return;
    }
  }

  const LadderStart& start_;
  const TakeARoad& take_;
  std::shared_ptr<Taken> last_;  ///< that led somewhere
  bool dual_wandered_ = false;   ///< on some road
  RoadKeeper<Taken> keeper_;
};

}  // namespace

Status ClimbLadder(const LadderStart& start, const TakeARoad& take, Parameterization* result) {
  return Climb(start, take).Run(result);
}

}  // namespace cirque

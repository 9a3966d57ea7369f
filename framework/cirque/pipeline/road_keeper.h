#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "cirque/core/status.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/summaries.h"

namespace cirque {

/// How a road ended, as far as the ladder tells ends apart.
enum class RoadEnd {
  kMap,
  kImprecise,  ///< a map with a Shortcoming
  kInfeasible,
  kUnrepresentable,
  kNotConverged,
  kStopped  ///< cancelled, bad input, a failing machine: nothing else is tried
};

/// What speaks for another road than one that led to a map: what misses kAccuracy, or that the exact map
/// lies about several origins; empty: nothing.
std::string Shortcoming(const Certificate& certificate);

/// How a road ended that came back with this status and certificate.
RoadEnd EndOfRoad(const Status& status, const Certificate& certificate);

/// Why another road was taken than one that ended so, for people.
const char* WhyAnotherRoad(RoadEnd end);

/// What the message of a failure ends with where other roads were tried.
std::string OtherRoads(const LadderSummary& ladder);

/// What the name of the road that was asked for is among the rungs of a ladder.
inline constexpr char kAsAsked[] = "as_asked";

/// The best of the roads that a ladder took, and the list of all. Taken has `status`, `end` and `map`,
/// whose certificate is filled in.
template <class Taken>
class RoadKeeper {
 public:
  /// How the road ended, noted in it and in the list.
  void Note(const char* name, double seconds, Taken* taken) {
    const Certificate& certificate = taken->map.certificate;
    taken->end = EndOfRoad(taken->status, certificate);
    const bool imprecise = taken->end == RoadEnd::kImprecise;
    const bool inaccurate = imprecise && !Inaccuracy(certificate).empty();
    ladder_.tried.push_back({name, inaccurate ? kInaccurate : ToString(taken->status.code()),
                             imprecise ? Shortcoming(certificate) : taken->status.message(),
                             seconds});
  }

  /// Of the road that was asked for, and of one that was cancelled: keeps it.
  void Keep(std::shared_ptr<Taken> taken) { kept_ = std::move(taken); }

  /// Keeps the road of a rung if it is the best so far; whether it is all that was hoped for.
  /// `made_with`: the rung's, for people; `same_problem`: a proof on it is one about what was asked for.
  bool KeepBest(const char* made_with, bool same_problem, const std::shared_ptr<Taken>& taken) {
    const bool is_map = taken->end == RoadEnd::kMap;
    const bool better = is_map || (taken->end == RoadEnd::kImprecise && !kept_->status.ok());
    const bool proves =
        same_problem && taken->end == RoadEnd::kInfeasible && kept_->end == RoadEnd::kNotConverged;
    if (better) ladder_.made_with = made_with;
    if (better || proves) kept_ = taken;
    return is_map;
  }

  void CountRung() { ++ladder_.rungs_tried; }
  bool HasTriedOthers() const { return ladder_.tried.size() > 1; }
  bool HasTried(const std::string& name) const {
    return std::any_of(ladder_.tried.begin(), ladder_.tried.end(),
                       [&](const RungSummary& tried) { return tried.rung == name; });
  }

  /// Keeps the road of a rung instead of a map.
  void Prefer(const char* made_with, std::shared_ptr<Taken> taken) {
    ladder_.made_with = made_with;
    kept_ = std::move(taken);
  }

  /// Writes the list into the kept road's certificate and, of a failure, that there is one into its
  /// message. `first`: how the road that was asked for ended.
  void Describe(RoadEnd first) {
    Status& status = kept_->status;
    if (!ladder_.made_with.empty()) ladder_.since = WhyAnotherRoad(first);
    const bool failed = !status.ok() && status.code() != StatusCode::kCancelled;
    if (failed) status = Status(status.code(), status.message() + OtherRoads(ladder_));
    kept_->map.certificate.ladder = std::move(ladder_);
  }

  Taken& kept() const { return *kept_; }

 private:
  std::shared_ptr<Taken> kept_;
  LadderSummary ladder_;
};

}  // namespace cirque

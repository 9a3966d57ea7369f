#include "cirque/pipeline/road_keeper.h"

#include <fmt/format.h>

#include "cirque/core/count.h"

namespace cirque {

std::string Shortcoming(const Certificate& certificate) {
  std::string missed = Inaccuracy(certificate);
  const bool about_several = certificate.exact_map && certificate.exact_map->exact_origins;
  if (missed.empty() && about_several) missed = "doubles do not hold the map about one origin";
  return missed;
}

RoadEnd EndOfRoad(const Status& status, const Certificate& certificate) {
  switch (status.code()) {
    case StatusCode::kOk:
      return Shortcoming(certificate).empty() ? RoadEnd::kMap : RoadEnd::kImprecise;
    case StatusCode::kInfeasible:
      return RoadEnd::kInfeasible;
    case StatusCode::kUnrepresentable:
      return RoadEnd::kUnrepresentable;
    case StatusCode::kNotConverged:
      return RoadEnd::kNotConverged;
    default:
      return RoadEnd::kStopped;
  }
}

const char* WhyAnotherRoad(RoadEnd end) {
  switch (end) {
    case RoadEnd::kImprecise:
      return "doubles could not hold the map accurately about one origin";
    case RoadEnd::kInfeasible:
      return "no coherent angles exist without";
    case RoadEnd::kUnrepresentable:
      return "doubles could not hold the map";
    case RoadEnd::kMap:
      return "the map was distorted";
    default:
      return "the solve did not converge";
  }
}

std::string OtherRoads(const LadderSummary& ladder) {
  if (ladder.rungs_tried == 0 || ladder.tried.empty()) return "";
  // That rung's metric exists for all cones; what it may lack is room for the input's triangles.
  const RungSummary& last = ladder.tried.back();
  const bool exact =
      last.rung == "equivalence" && last.outcome == ToString(StatusCode::kNotConverged);
  return fmt::format(" ({} tried: see the certificate{})", Count(ladder.rungs_tried, "other road"),
                     exact ? "; --exact=OUT may have a map" : "");
}

}  // namespace cirque

#include "cirque/pipeline/fullest_map.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cirque/core/solve_summary.h"
#include "cirque/cuts/registry.h"
#include "cirque/layout/packing.h"

namespace cirque {
namespace {

std::vector<std::string> CandidatesOf(const ParameterizeOptions& options) {
  if (options.own_cut) return options.own_cut->Candidates();
  const auto heuristic = ParseCutHeuristic(options.cut_cost);
  return heuristic.ok() ? (*heuristic)->Candidates() : std::vector<std::string>();
}

}  // namespace

Status MapFullest(const ParameterizeOptions& options, const MapByOptions& make,
                  Parameterization* result) {
  const std::vector<std::string> candidates = CandidatesOf(options);
  if (candidates.empty()) return make(options, result);
  const Parameterization start = *result;
  std::optional<double> most;
  std::optional<Status> failed;
  int tried = 0;
  for (const std::string& name : candidates) {
    ParameterizeOptions by_name = options;
    by_name.cut_cost = name;
    by_name.own_cut = nullptr;
    Parameterization map = start;
    Status status = make(by_name, &map);
    if (status.code() == StatusCode::kCancelled) return status;
    if (status.ok()) ++tried;
    const double used = status.ok() ? AreaUsed(map.uv) : -1;
    // What fails is the result only while there is nothing better.
    if (status.ok() ? !most || used > *most : !most && !failed) *result = std::move(map);
    if (status.ok()) most = std::max(used, most.value_or(used));
    if (!status.ok() && !failed) failed = std::move(status);
  }
  if (!most) return *failed;
  Fill(&result->certificate.layout).cuts_tried = tried;
  return Status();
}

}  // namespace cirque

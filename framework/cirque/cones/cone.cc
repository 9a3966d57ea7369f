#include "cirque/cones/cone.h"

#include <fmt/format.h>

#include "cirque/core/gauss_bonnet.h"

namespace cirque {
namespace {

constexpr double kRounding = 1e-9;  ///< [rad] of a sum of all targets

/// What is wrong with a cone; empty: nothing.
std::string Fault(const Cone& cone, const std::vector<Index>& corners) {
  const auto count = static_cast<Index>(corners.size());
  if (cone.vertex < 0 || cone.vertex >= count) {
    return fmt::format("the surface has vertices 0 to {} only", count - 1);
  }
  if (!(cone.lower <= cone.upper && cone.lower >= 0 && cone.upper > 0)) {
    return fmt::format(
        "its angle sum is to lie in [{}, {}] rad: give 0 <= lower <= upper, upper > 0", cone.lower,
        cone.upper);
  }
  if (cone.lower >= kPi * corners[cone.vertex]) {
    return fmt::format("its {} corners, each less than pi, cannot add up to {:.6g} pi",
                       corners[cone.vertex], cone.lower / kPi);
  }
  return {};
}

}  // namespace

StatusOr<ConeTargets> ConeTargetsOf(const Triangulation& t, const std::vector<Cone>& cones) {
  ConeTargets targets = FreeBoundaryTargets(t);
  const std::vector<Index> corners = CornersPerVertex(t);
  std::vector<bool> named(t.num_vertices, false);
  for (const Cone& cone : cones) {
    std::string fault = Fault(cone, corners);
    if (fault.empty() && named[cone.vertex]) fault = "it is named twice";
    if (!fault.empty()) {
      return Status::InvalidInput(
          fmt::format("cone at vertex {} (0-based): {}", cone.vertex, fault));
    }
    named[cone.vertex] = true;
    targets.lower[cone.vertex] = cone.lower;
    targets.upper[cone.vertex] = cone.upper;
  }
  const GaussBonnetDefect defect = MeasureGaussBonnetDefect(t, targets);
  if (BoundaryLoops(t).empty() && !defect.IsZeroPossible(kRounding)) {
    return Status::InvalidInput(
        fmt::format("Gauss-Bonnet: {} cones leave the angle sums {:.6g} pi {} what the triangles "
                    "have; a closed "
                    "surface needs cones of curvature {} pi in all",
                    cones.size(), std::abs(defect.lower > 0 ? defect.lower : defect.upper) / kPi,
                    defect.lower > 0 ? "above" : "below", 2 * EulerCharacteristic(t)));
  }
  return targets;
}

std::vector<Cone> ConesOf(const Triangulation& t, const ConeTargets& targets) {
  const ConeTargets plain = FreeBoundaryTargets(t);
  std::vector<Cone> cones;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (targets.lower[v] == plain.lower[v] && targets.upper[v] == plain.upper[v]) continue;
    cones.push_back({v, targets.lower[v], targets.upper[v]});
  }
  return cones;
}

}  // namespace cirque

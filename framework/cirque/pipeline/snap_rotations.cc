#include "cirque/pipeline/snap_rotations.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cirque/layout/seams.h"
#include "cirque/metrics/injectivity.h"

namespace cirque {
namespace {

constexpr double kMultiple = 1e-12;  ///< [rad]: of targets, which are read with some digits
constexpr double kRotation = 1e-6;   ///< [rad]: of seams, which carry the errors of a solve

}  // namespace

int CommonRotationOrder(const ConeTargets& targets, const std::vector<Index>& cones) {
  for (const int order : {4, 6}) {
    const bool fits = std::all_of(cones.begin(), cones.end(), [&](Index v) {
      const double step = 2 * kPi / order;
      return targets.IsFixed(v) && std::abs(std::remainder(targets.lower[v], step)) <= kMultiple;
    });
    if (fits) return order;
  }
  return 0;
}

bool SnapRotations(const Triangulation& t, const Cut& cut, const std::vector<Index>& cones,
                   const CornerAngles& flat_angles, int order, CornerUv* uv) {
  const SeamReport seams = MeasureSeams(t, cut, cones, flat_angles, *uv);
  const auto multiple = IntegerRotations(t, seams, order, kRotation);
  if (!multiple.ok()) return false;
  if (seams.seams.empty()) return true;
  CornerUv snapped = *uv;
  SnapSeams(t, cut, seams, *multiple, order, &snapped);
  if (!FlippedFaces(t, snapped).empty()) return false;
  *uv = std::move(snapped);
  return true;
}

}  // namespace cirque

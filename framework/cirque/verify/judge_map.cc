#include "cirque/verify/judge_map.h"

#include <fmt/format.h>

#include "cirque/verify/map_check.h"
#include "cirque/verify/sphere_check.h"

namespace cirque {
namespace {

template <class Report>
MapVerdict VerdictOf(const Report& report) {
  return {report.valid(), report.Verdict(), report.errors, verify::ToJson(report)};
}

}  // namespace

const OptionTable<JudgeOptions>& JudgeOptionTable() {
  using O = JudgeOptions;
  static const OptionTable<O> kTable(
      "verify",
      {Option<O>("domain", &O::domain,
                 "disk: the boundary must lie on the unit circle; round_holes: and "
                 "that of holes on circles")
           .OneOf({"plane", "disk", "round_holes", "sphere"}),
       Option<O>("position_tolerance", &O::position_tolerance,
                 "a vertex may be off by this part of the bounding box")
           .Between(0, 1),
       Option<O>("angle_tolerance", &O::angle_tolerance, "a seam vertex off 2 pi by more is a cone")
           .Between(0, 1)
           .Unit("rad"),
       Option<O>("circle_tolerance", &O::circle_tolerance, "of the unit circle").Between(0, 1),
       Option<O>("radius_tolerance", &O::radius_tolerance, "of points on the sphere").Between(0, 1),
       {"require_injective", &O::require_injective, "an overlap makes the map invalid"}});
  return kTable;
}

StatusOr<MapVerdict> JudgeMap(const PolygonSoup& mesh, const PolygonSoup& mapped,
                              const JudgeOptions& options) {
  if (Status s = JudgeOptionTable().Validate(options); !s.ok()) return s;
  verify::VerifyOptions wanted;
  wanted.position_tolerance = options.position_tolerance;
  wanted.angle_tolerance = options.angle_tolerance;
  wanted.round_holes = options.domain == "round_holes";
  wanted.unit_disk = wanted.round_holes || options.domain == "disk";
  wanted.circle_tolerance = options.circle_tolerance;
  wanted.require_injective = options.require_injective;
  const StatusOr<verify::MapReport> report = verify::VerifyMap(mesh, mapped, wanted);
  if (!report.ok()) return report.status();
  return VerdictOf(*report);
}

StatusOr<MapVerdict> JudgeSphereMap(const PolygonSoup& mesh,
                                    const std::vector<Eigen::Vector3d>& position,
                                    const JudgeOptions& options) {
  if (Status s = JudgeOptionTable().Validate(options); !s.ok()) return s;
  if (position.size() != mesh.position.size()) {
    return Status::InvalidInput(fmt::format("{} points on the sphere for {} vertices",
                                            position.size(), mesh.position.size()));
  }
  PolygonSoup mapped = mesh;
  mapped.position = position;
  const auto report = verify::VerifySphereMap(mesh, mapped, {options.radius_tolerance});
  if (!report.ok()) return report.status();
  return VerdictOf(*report);
}

}  // namespace cirque

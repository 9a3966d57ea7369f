#include "experiments/circle_patterns/prescriptions.h"

#include <utility>

namespace cirque {

StatusOr<std::optional<ConeTargets>> PrescribedTargets(const CirclePatternsJob& job,
                                                       const Triangulation& t,
                                                       const FileVertices& vertices) {
  if (job.angle_sums.empty() && job.cones.empty()) return std::optional<ConeTargets>();
  StatusOr<ConeTargets> targets = job.angle_sums.empty()
                                      ? ReadConeFile(job.cones, t, vertices)
                                      : ReadAngleSumFile(job.angle_sums, t, vertices);
  if (!targets.ok()) return targets.status();
  return std::optional<ConeTargets>(*std::move(targets));
}

StatusOr<std::optional<Cut>> PrescribedCut(const CirclePatternsJob& job, const Triangulation& t,
                                           const FileNumbers& numbers) {
  if (job.cut.empty()) return std::optional<Cut>();
  StatusOr<Cut> cut = ReadCutFile(job.cut, t, numbers);
  if (!cut.ok()) return cut.status();
  return std::optional<Cut>(*std::move(cut));
}

}  // namespace cirque

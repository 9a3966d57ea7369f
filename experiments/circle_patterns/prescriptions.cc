#include "experiments/circle_patterns/prescriptions.h"

#include <utility>

namespace cirque {

StatusOr<ConeTargets> PrescribedTargets(const CirclePatternsJob& job, const Triangulation& t,
                                        const EdgeLengths& lengths, const FileVertices& vertices) {
  if (!job.angle_sums.empty()) return ReadAngleSumFile(job.angle_sums, t, vertices);
  if (!job.cones.empty()) return ReadConeFile(job.cones, t, vertices);
  return DefaultTargets(t, lengths);
}

StatusOr<std::optional<Cut>> PrescribedCut(const CirclePatternsJob& job, const Triangulation& t,
                                           const FileNumbers& numbers) {
  if (job.cut.empty()) return std::optional<Cut>();
  StatusOr<Cut> cut = ReadCutFile(job.cut, t, numbers);
  if (!cut.ok()) return cut.status();
  return std::optional<Cut>(*std::move(cut));
}

}  // namespace cirque

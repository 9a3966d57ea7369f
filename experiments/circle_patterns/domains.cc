#include "experiments/circle_patterns/domains.h"

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/text.h"
#include "cirque/domains/registry.h"

#include "experiments/circle_patterns/file_numbering.h"
#include "experiments/circle_patterns/prescriptions.h"

namespace cirque {
namespace {

/// Flags of the program's own; those of gflags and of other libraries have no say here.
bool IsGiven(const std::string& flag) {
  gflags::CommandLineFlagInfo info;
  return gflags::GetCommandLineFlagInfo(flag.c_str(), &info) && !info.is_default;
}

StatusOr<DomainOptions> OptionsOf(const DomainRequest& request, const FileNumbering& numbers) {
  DomainOptions options;
  if (Status s = numbers.Read("centre", request.centre, &options.centre); !s.ok()) return s;
  if (Status s = numbers.Read("angle_zero", request.angle_zero, &options.angle_zero); !s.ok()) {
    return s;
  }
  if (Status s = numbers.Read("pole", request.pole, &options.pole); !s.ok()) return s;
  if (Status s = numbers.ReadList("corners", request.corners, &options.corners); !s.ok()) return s;
  if (!request.normalization.empty()) options.normalization = request.normalization;
  if (request.sides != 0) options.sides = request.sides;
  return options;
}

}  // namespace

Status CheckDomainFlags(const std::string& name) {
  const Domain* domain = FindDomain(name);
  if (!domain) return Status::InvalidInput(UnknownName("domain", name, DomainNames()));
  for (const Domain& other : Domains()) {
    for (const std::string& flag : other.reads) {
      if (!IsGiven(flag) || !IsForeign(*domain, flag)) continue;
      return Status::InvalidInput(
          fmt::format("--domain={} takes no --{}; it takes {}", name, flag, Join(domain->reads)));
    }
  }
  if (IsGiven("corners") && IsGiven("sides")) {
    return Status::InvalidInput("give --corners or --sides, not both");
  }
  const bool by_file = IsGiven("iv") || IsGiven("angle_sums");
  if (name == "polygon" && by_file && (IsGiven("corners") || IsGiven("sides"))) {
    return Status::InvalidInput(
        "the file of angle sums names the polygon's corners; leave out --corners and --sides");
  }
  return Status();
}

Status MapToDomain(const CirclePatternsJob& job, Index num_file_vertices, const Surface& surface,
                   const SolveControl& control, Parameterization* map) {
  const auto options = OptionsOf(job.domain, FileNumbering(surface, num_file_vertices));
  if (!options.ok()) return options.status();
  if (!job.cones.empty() || !job.angle_sums.empty()) {
    const auto targets =
        PrescribedTargets(job, surface.triangulation, {num_file_vertices, surface.soup_vertex});
    if (!targets.ok()) return targets.status();
    return MapToExteriorAngles(surface, **targets, job.options, control, map);
  }
  return FindDomain(job.domain.name)->map(surface, *options, job.options, control, map);
}

}  // namespace cirque

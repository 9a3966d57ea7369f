#include "experiments/circle_patterns/domains.h"

#include <algorithm>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/text.h"

#include "experiments/circle_patterns/file_numbering.h"
#include "experiments/circle_patterns/prescriptions.h"

namespace cirque {
namespace {

using DomainMap = Status (*)(const Surface&, const DomainOptions&, const ParameterizeOptions&,
                             const SolveControl&, Parameterization*);

Status MapToTriangle(const Surface& surface, const DomainOptions& domain,
                     const ParameterizeOptions& options, const SolveControl& control,
                     Parameterization* result) {
  if (!domain.corners.empty() && domain.corners.size() != 3) {
    return Status::InvalidInput(
        fmt::format("a triangle has 3 corners, not {}", domain.corners.size()));
  }
  DomainOptions three = domain;
  three.sides = 3;
  return MapToPolygon(surface, three, options, control, result);
}

struct Domain {
  std::string name;
  std::vector<std::string> flags;  ///< that it reads, of those that not every domain does
  DomainMap map;
};

const std::vector<Domain>& Domains() {
  static const std::vector<Domain> kTable = {
      {"plane",
       {"iv", "angle_sums", "ie", "cut_paths", "oc", "flip_back", "ic", "no", "layout", "cones",
        "cone_budget", "cone_angles", "refine_cones", "cut_cost", "edge_costs", "measures",
        "fill_holes"},
       nullptr},
      {"sphere",
       {"pole", "normalization", "principal_axes", "inversion", "latlong", "layout"},
       nullptr},
      {"disk",
       {"centre", "angle_zero", "pole", "normalization", "measures", "fill_holes"},
       MapToDisk},
      {"half_plane", {"pole", "measures", "fill_holes"}, MapToHalfPlane},
      {"rectangle", {"corners", "measures", "fill_holes"}, MapToRectangle},
      {"polygon", {"corners", "sides", "iv", "angle_sums", "measures", "fill_holes"}, MapToPolygon},
      {"triangle", {"corners", "measures", "fill_holes"}, MapToTriangle}};
  return kTable;
}

const Domain* FindDomain(const std::string& name) {
  const auto domain = std::find_if(Domains().begin(), Domains().end(),
                                   [&](const Domain& d) { return d.name == name; });
  return domain == Domains().end() ? nullptr : &*domain;
}

bool Reads(const Domain& domain, const std::string& flag) {
  return std::find(domain.flags.begin(), domain.flags.end(), flag) != domain.flags.end();
}

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

std::vector<std::string> DomainNames() {
  std::vector<std::string> names;
  for (const Domain& domain : Domains()) names.push_back(domain.name);
  return names;
}

Status CheckDomainFlags(const std::string& name) {
  const Domain* domain = FindDomain(name);
  if (!domain) return Status::InvalidInput(UnknownName("domain", name, DomainNames()));
  for (const Domain& other : Domains()) {
    for (const std::string& flag : other.flags) {
      if (!IsGiven(flag) || Reads(*domain, flag)) continue;
      return Status::InvalidInput(
          fmt::format("--domain={} takes no --{}; it takes {}", name, flag, Join(domain->flags)));
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

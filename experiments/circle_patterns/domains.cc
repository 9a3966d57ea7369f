#include "experiments/circle_patterns/domains.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

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

/// The flags that stand for what a domain reads or gives, where they are not called like it.
std::vector<std::string> FlagsFor(const std::string& member) {
  static const std::map<std::string, std::vector<std::string>> kFlags = {
      {"targets", {"iv", "angle_sums"}},  {"cut", {"ie", "cut_paths"}},
      {"metric", {"ic", "no"}},           {"flat", {"oc", "flip_back"}},
      {"uv", {"measures", "fill_holes"}}, {"position", {"latlong"}}};
  const auto found = kFlags.find(member);
  return found == kFlags.end() ? std::vector<std::string>{member} : found->second;
}

/// The flags that the domain takes and not every domain does.
std::vector<std::string> FlagsOf(const Domain& domain) {
  std::vector<std::string> flags;
  for (const auto* members : {&domain.reads, &domain.gives}) {
    for (const std::string& member : *members) {
      for (const std::string& flag : FlagsFor(member)) flags.push_back(flag);
    }
  }
  return flags;
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
  options.principal_axes = request.principal_axes;
  options.inversion = request.inversion;
  return options;
}

}  // namespace

Status CheckDomainFlags(const std::string& name) {
  const StatusOr<Domain> domain = Domains().Find(name);
  if (!domain.ok()) return domain.status();
  const std::vector<std::string> own = FlagsOf(*domain);
  for (const std::string& other : Domains().Names()) {
    for (const std::string& flag : FlagsOf(*Domains().Find(other))) {
      if (!IsGiven(flag) || std::find(own.begin(), own.end(), flag) != own.end()) continue;
      return Status::InvalidInput(
          fmt::format("--domain={} takes no --{}; it takes {}", name, flag, Join(own)));
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

StatusOr<MapRequest> RequestOf(const CirclePatternsJob& job, Index num_file_vertices,
                               const Surface& surface) {
  MapRequest request;
  request.domain = job.domain.name;
  request.options = job.options;
  auto shape = OptionsOf(job.domain, FileNumbering(surface, num_file_vertices));
  if (!shape.ok()) return shape.status();
  request.shape = *std::move(shape);
  auto targets =
      PrescribedTargets(job, surface.triangulation, {num_file_vertices, surface.soup_vertex});
  if (!targets.ok()) return targets.status();
  request.targets = *std::move(targets);
  auto cut = PrescribedCut(job, surface.triangulation, MeasureEdgeLengths(surface),
                           NumbersInFile(surface));
  if (!cut.ok()) return cut.status();
  request.cut = *std::move(cut);
  return request;
}

}  // namespace cirque

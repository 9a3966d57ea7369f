#include "experiments/circle_patterns/domains.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/domains/domain.h"

#include "experiments/circle_patterns/file_numbering.h"
#include "experiments/circle_patterns/prescriptions.h"

namespace cirque {
namespace {

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
  OptionMap shape = request.shape;
  for (const OptionInfo& option : DomainOptionTable().Infos()) {
    const auto given = shape.find(option.name);
    if (option.unit != kVertexUnit || given == shape.end()) continue;
    const StatusOr<std::vector<Index>> vertices = numbers.Read(option.name, given->second);
    if (!vertices.ok()) return vertices.status();
    given->second = ToText(*vertices);
  }
  std::erase_if(shape, [](const auto& entry) { return entry.second.empty(); });
  DomainOptions options;
  const Status status = DomainOptionTable().Set(shape, &options);
  return status.ok() ? StatusOr<DomainOptions>(options) : status;
}

}  // namespace

Status CheckDomainFlags(const std::string& name,
                        const std::function<bool(const std::string&)>& is_given) {
  const StatusOr<Domain> domain = Domains().Find(name);
  if (!domain.ok()) return domain.status();
  const std::vector<std::string> own = FlagsOf(*domain);
  for (const std::string& other : Domains().Names()) {
    for (const std::string& flag : FlagsOf(*Domains().Find(other))) {
      if (!is_given(flag) || std::find(own.begin(), own.end(), flag) != own.end()) continue;
      return Status::InvalidInput(
          fmt::format("--domain={} takes no --{}; it takes {}", name, flag, Join(own)));
    }
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

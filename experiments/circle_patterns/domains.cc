#include "experiments/circle_patterns/domains.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "cirque/core/text.h"

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
      {"plane", {"iv", "angle_sums", "ie", "oc", "layout"}, nullptr},
      {"disk", {"centre", "angle_zero", "pole", "normalization"}, MapToDisk},
      {"half_plane", {"pole"}, MapToHalfPlane},
      {"rectangle", {"corners"}, MapToRectangle},
      {"polygon", {"corners", "sides", "iv", "angle_sums"}, MapToPolygon},
      {"triangle", {"corners"}, MapToTriangle}};
  return kTable;
}

/// Every flag that some domain does not read, and whether it was given.
std::vector<std::pair<std::string, bool>> GivenFlags(const CirclePatternsJob& job) {
  const DomainRequest& domain = job.domain;
  return {{"iv", !job.cones.empty()},
          {"angle_sums", !job.angle_sums.empty()},
          {"ie", !job.cut.empty()},
          {"oc", !job.con.empty()},
          {"layout", job.options.layout != ParameterizeOptions().layout},
          {"centre", !domain.centre.empty()},
          {"angle_zero", !domain.angle_zero.empty()},
          {"pole", !domain.pole.empty()},
          {"normalization", domain.normalization != DomainOptions().normalization},
          {"corners", !domain.corners.empty()},
          {"sides", domain.sides != 0}};
}

/// Vertices of the surface by the numbers that their file gives them.
class FileNumbering {
 public:
  FileNumbering(const Surface& surface, Index count) : of_file_(count, kNone) {
    for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
      if (surface.soup_vertex[v] != kNone) of_file_[surface.soup_vertex[v]] = v;
    }
  }

  /// One vertex, or kNone where the flag is empty.
  Status Read(const char* flag, const std::string& text, Index* vertex) const {
    if (text.empty()) return Status();
    Index number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) {
      return Status::InvalidInput(
          fmt::format("--{}: '{}' is no vertex; give its number, from 0", flag, text));
    }
    if (number < 0 || number >= static_cast<Index>(of_file_.size()) || of_file_[number] == kNone) {
      return Status::InvalidInput(
          fmt::format("--{}: no face has vertex {}; the mesh has vertices 0 to {}", flag, number,
                      static_cast<Index>(of_file_.size()) - 1));
    }
    *vertex = of_file_[number];
    return Status();
  }

  /// "3,17,4".
  Status ReadList(const char* flag, const std::string& text, std::vector<Index>* vertices) const {
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      Index vertex = kNone;
      const std::string word = text.substr(begin, end - begin);
      if (Status s = Read(flag, word.empty() ? "," : word, &vertex); !s.ok()) return s;
      vertices->push_back(vertex);
      begin = end + 1;
    }
    return Status();
  }

 private:
  std::vector<Index> of_file_;
};

StatusOr<DomainOptions> OptionsOf(const DomainRequest& request, const FileNumbering& numbers) {
  DomainOptions options;
  if (Status s = numbers.Read("centre", request.centre, &options.centre); !s.ok()) return s;
  if (Status s = numbers.Read("angle_zero", request.angle_zero, &options.angle_zero); !s.ok()) {
    return s;
  }
  if (Status s = numbers.Read("pole", request.pole, &options.pole); !s.ok()) return s;
  if (Status s = numbers.ReadList("corners", request.corners, &options.corners); !s.ok()) return s;
  options.normalization = request.normalization;
  if (request.sides != 0) options.sides = request.sides;
  return options;
}

}  // namespace

std::vector<std::string> DomainNames() {
  std::vector<std::string> names;
  for (const Domain& domain : Domains()) names.push_back(domain.name);
  return names;
}

Status CheckDomainFlags(const CirclePatternsJob& job) {
  const std::string& name = job.domain.name;
  const auto domain = std::find_if(Domains().begin(), Domains().end(),
                                   [&](const Domain& d) { return d.name == name; });
  if (domain == Domains().end()) {
    return Status::InvalidInput(UnknownName("domain", name, DomainNames()));
  }
  for (const auto& [flag, given] : GivenFlags(job)) {
    const bool reads =
        std::find(domain->flags.begin(), domain->flags.end(), flag) != domain->flags.end();
    if (!given || reads) continue;
    return Status::InvalidInput(
        fmt::format("--domain={} takes no --{}; it takes {}", name, flag, Join(domain->flags)));
  }
  const bool by_file = !job.cones.empty() || !job.angle_sums.empty();
  if (name == "polygon" && by_file && (!job.domain.corners.empty() || job.domain.sides != 0)) {
    return Status::InvalidInput(
        "the file of angle sums names the polygon's corners; leave out --corners and --sides");
  }
  if (!job.domain.corners.empty() && job.domain.sides != 0) {
    return Status::InvalidInput("give --corners or --sides, not both");
  }
  if (domain->map && !job.input_con.empty()) {
    return Status::InvalidInput(fmt::format("--domain={} takes a mesh (-io), not a metric", name));
  }
  return Status();
}

Status MapToDomain(const CirclePatternsJob& job, Index num_file_vertices, const Surface& surface,
                   const SolveControl& control, Parameterization* map) {
  const auto options = OptionsOf(job.domain, FileNumbering(surface, num_file_vertices));
  if (!options.ok()) return options.status();
  if (!job.cones.empty() || !job.angle_sums.empty()) {
    const auto targets = PrescribedTargets(job, surface.triangulation, MeasureEdgeLengths(surface),
                                           {num_file_vertices, surface.soup_vertex});
    if (!targets.ok()) return targets.status();
    return MapToExteriorAngles(surface, *targets, job.options, control, map);
  }
  const auto domain = std::find_if(Domains().begin(), Domains().end(),
                                   [&](const Domain& d) { return d.name == job.domain.name; });
  return domain->map(surface, *options, job.options, control, map);
}

}  // namespace cirque

#include "cirque/domains/registry.h"

#include <algorithm>

#include <fmt/format.h>

namespace cirque {
namespace {

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

bool Reads(const Domain& domain, const std::string& flag) {
  return std::find(domain.reads.begin(), domain.reads.end(), flag) != domain.reads.end();
}

}  // namespace

const std::vector<Domain>& Domains() {
  static const std::vector<Domain> kTable = {
      {"plane",
       {"iv", "angle_sums", "ie", "cut_paths", "oc", "flip_back", "ic", "no", "layout", "cones",
        "cone_budget", "cone_angles", "refine_cones", "refine_map", "seams", "cut_cost",
        "edge_costs", "measures", "fill_holes"},
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

std::vector<std::string> DomainNames() {
  std::vector<std::string> names;
  for (const Domain& domain : Domains()) names.push_back(domain.name);
  return names;
}

const Domain* FindDomain(const std::string& name) {
  const auto domain = std::find_if(Domains().begin(), Domains().end(),
                                   [&](const Domain& d) { return d.name == name; });
  return domain == Domains().end() ? nullptr : &*domain;
}

bool IsForeign(const Domain& domain, const std::string& flag) {
  return !Reads(domain, flag) &&
         std::any_of(Domains().begin(), Domains().end(),
                     [&](const Domain& other) { return Reads(other, flag); });
}

}  // namespace cirque

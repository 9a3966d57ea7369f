#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/solve_summary.h"
#include "cirque/core/text.h"
#include "cirque/domains/built_in_domains.h"
#include "cirque/domains/domain.h"
#include "cirque/domains/extreme_scale.h"

namespace cirque {
namespace {

bool Contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// What would else be ignored, or read beyond the surface's vertices.
Status CheckRequest(const Domain& domain, const MapRequest& request, Index num_vertices) {
  for (const auto& [option, given] : {std::pair("targets", request.targets.has_value()),
                                      std::pair("cut", request.cut.has_value())}) {
    if (!given || domain.Reads(option)) continue;
    return Status::InvalidInput(fmt::format("the domain {} takes no {}", request.domain, option));
  }
  if (Status s = ParameterizeOptionTable().Validate(request.options); !s.ok()) return s;
  if (Status s = DomainOptionTable().Validate(request.shape); !s.ok()) return s;
  std::vector<Index> vertices = request.shape.corners;
  for (const Index v : {request.shape.centre, request.shape.angle_zero, request.shape.pole}) {
    if (v != kNone) vertices.push_back(v);
  }
  for (const Index v : vertices) {
    if (v >= 0 && v < num_vertices) continue;
    return Status::InvalidInput(fmt::format("{} is no vertex: there are {}", v, num_vertices));
  }
  return Status();
}

/// Maps where squares of lengths are numbers, and back.
Status MapAtSafeScale(const Domain& domain, const Surface& surface, const MapRequest& request,
                      const SolveControl& control, SurfaceMap* map) {
  const int exponent = ExtremeExponent(surface);
  if (exponent == 0) return domain.map(surface, request, control, map);
  Status status = domain.map(Scaled(surface, -exponent), request, control, map);
  // The others' images have a size of their own.
  if (status.ok() && domain.Gives("flat")) ScaleMap(exponent, map);
  return status;
}

}  // namespace

const Registry<Domain>& Domains() {
  static const Registry<Domain> kTable(
      "domain",
      {{"plane",
        {"the plane, opened along a cut through cones where it must be",
         {"targets", "cut", "metric", "layout", "cones", "cone_budget", "cone_angles",
          "refine_cones", "refine_map", "seams", "cut_cost", "edge_costs", "strict"},
         {"uv", "flat"},
         MapToPlane}},
       {"sphere",
        {"the unit sphere, for closed surfaces of genus 0",
         {"pole", "normalization", "principal_axes", "inversion", "layout", "refine_map"},
         {"position"},
         MapToSphere}},
       {"disk",
        {"the unit disk, for topological disks like all that follow",
         {"centre", "angle_zero", "pole", "normalization", "refine_map"},
         {"uv"},
         MapToDisk}},
       {"half_plane",
        {"the upper half-plane, one boundary vertex belonging at infinity",
         {"pole"},
         {"uv"},
         MapToHalfPlane}},
       {"rectangle",
        {"a rectangle of height 1", {"corners", "refine_map", "strict"}, {"uv"}, MapToRectangle}},
       {"polygon",
        {"a polygon of equal or given angles",
         {"corners", "sides", "targets", "refine_map", "strict"},
         {"uv"},
         MapToPolygon}},
       {"triangle",
        {"an equilateral triangle", {"corners", "refine_map", "strict"}, {"uv"}, MapToTriangle}}});
  return kTable;
}

bool Domain::Reads(const std::string& option) const { return Contains(reads, option); }

bool Domain::Gives(const std::string& member) const { return Contains(gives, member); }

bool IsReadBySomeDomain(const std::string& option) {
  const std::vector<std::string> names = Domains().Names();
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return Domains().Find(name)->Reads(option); });
}

StatusOr<SurfaceMap> MapSurface(const Surface& surface, const MapRequest& request,
                                const SolveControl& control, Certificate* failed) {
  return MapSurface(surface, request, control, failed, Domains());
}

StatusOr<SurfaceMap> MapSurface(const Surface& surface, const MapRequest& request,
                                const SolveControl& control, Certificate* failed,
                                const Registry<Domain>& domains) {
  const Timer timer;
  SurfaceMap map;
  const StatusOr<Domain> domain = domains.Find(request.domain);
  Status status = domain.status();
  if (status.ok()) status = CheckRequest(*domain, request, surface.triangulation.num_vertices);
  if (status.ok()) status = MapAtSafeScale(*domain, surface, request, control, &map);
  status = Conclude(status, timer, &map.certificate);
  if (status.ok()) return map;
  if (failed) *failed = std::move(map.certificate);
  return status;
}

}  // namespace cirque

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/core/count.h"
#include "cirque/core/solve_summary.h"
#include "cirque/domains/built_in_domains.h"
#include "cirque/domains/corner_places.h"
#include "cirque/domains/exact_disk.h"
#include "cirque/domains/unroll.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/math/moebius.h"
#include "cirque/pipeline/exact_layout.h"

namespace cirque {
namespace {

Status CheckTopology(const Triangulation& t, std::size_t loops, const char* domain,
                     const char* wanted) {
  const std::size_t found = BoundaryLoops(t).size();
  const Index chi = EulerCharacteristic(t);
  if (found == loops && chi == 0) return Status();
  const auto genus = (2 - static_cast<Index>(found) - chi) / 2;
  return Status::InvalidInput(
      fmt::format("the domain {} takes {}; this one is of genus {} with {}; choose another domain",
                  domain, wanted, genus, Count(found, "boundary loop")));
}

/// Puts the layout of what was solved there, for its exact map.
Status PutLayout(const std::vector<Complex>& place, const char* elsewhere, SolvedLayout* layout) {
  layout->uv.value.clear();
  for (const Complex z : place) layout->uv.value.emplace_back(z.real(), z.imag());
  return CheckSolvedNotFlipped(layout->surface.triangulation, layout->uv, elsewhere);
}

Status PutOnStrip(const Strip& strip, SolvedLayout* layout) {
  layout->grid = strip.grid;
  layout->summary.exact_strip_period = strip.period;
  return PutLayout(strip.place, "the plane", layout);
}

Status PutOnAnnulus(const Strip& strip, SolvedLayout* layout) {
  const Triangulation& t = layout->surface.triangulation;
  layout->cut.edge.assign(t.num_edges(), false);
  layout->summary.exact_inner_radius = InnerRadius(strip);
  return PutLayout(WindRound(t, strip), "a strip or the plane", layout);
}

/// How the strip of what was solved is put where its exact map is drawn.
using PutStrip = Status (*)(const Strip&, SolvedLayout*);

/// Flattens and lays out with both boundaries straight.
Status MapToCylinder(const Surface& surface, const MapRequest& request, Index bottom, PutStrip put,
                     const SolveControl& control, SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  ParameterizeRequest straight = {request.options, FreeBoundaryTargets(t)};
  const std::vector<bool> boundary = BoundaryVertices(t);
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (boundary[v]) straight.targets->lower[v] = straight.targets->upper[v] = kPi;
  }
  straight.place_exact = [=](SolvedLayout* layout) {
    return put(UnrollStrip(layout->surface.triangulation, layout->uv, bottom), layout);
  };
  return Parameterize(surface, straight, control, map);
}

StatusOr<Strip> MapToStripOf(const Surface& surface, const char* domain, PutStrip put,
                             const MapRequest& request, const SolveControl& control,
                             SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  Status status = CheckTopology(t, 2, domain, "a surface of genus 0 with two boundary loops");
  if (!status.ok()) return status;
  const Index bottom = VertexOnLongerLoop(t, MeasureEdgeLengths(surface));
  status = MapToCylinder(surface, request, bottom, put, control, map);
  if (!status.ok()) return status;
  Strip strip = UnrollStrip(t, map->uv, bottom);
  PeriodicSummary& summary = Fill(&map->certificate.periodic);
  summary.annulus_modulus = 1 / strip.period;
  summary.period_mismatch = strip.mismatch;
  return strip;
}

/// The largest relative distance of a boundary vertex from its circle.
double CircleError(const Triangulation& t, const Strip& strip, const std::vector<Complex>& wound) {
  double error = 0;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (t.twin[h] != kNone) continue;
    const Index tail = Triangulation::Next(h);
    const double radius = strip.place[tail].imag() == 1 ? InnerRadius(strip) : 1;
    error = std::max(error, std::abs(std::abs(wound[tail]) / radius - 1));
  }
  return error;
}

Status PutOnTorus(SolvedLayout* layout) {
  const auto torus =
      UnrollTorus(layout->surface.triangulation, layout->cut, layout->angles, layout->uv);
  if (!torus.ok()) return torus.status();
  layout->grid = torus->grid;
  layout->summary.exact_modulus_real = torus->tau.real();
  layout->summary.exact_modulus_imaginary = torus->tau.imag();
  return PutLayout(torus->place, "the plane", layout);
}

}  // namespace

Status MapToStrip(const Surface& surface, const MapRequest& request, const SolveControl& control,
                  SurfaceMap* map) {
  const StatusOr<Strip> strip = MapToStripOf(surface, "strip", PutOnStrip, request, control, map);
  if (!strip.ok()) return strip.status();
  map->certificate.periodic->strip_period = strip->period;
  return PutCorners(surface, strip->place, "doubles cannot hold the strip with its seam exact",
                    map);
}

Status MapToAnnulus(const Surface& surface, const MapRequest& request, const SolveControl& control,
                    SurfaceMap* map) {
  const StatusOr<Strip> strip =
      MapToStripOf(surface, "annulus", PutOnAnnulus, request, control, map);
  if (!strip.ok()) return strip.status();
  const Triangulation& t = surface.triangulation;
  const std::vector<Complex> place = WindRound(t, *strip);
  PeriodicSummary& summary = *map->certificate.periodic;
  summary.inner_radius = InnerRadius(*strip);
  summary.circle_error = CircleError(t, *strip, place);
  ForgetCut(t, map);
  return PutCorners(surface, place,
                    "the strip that is wound to an annulus exists, but its triangles, which stay "
                    "straight, are too large for the inner circle (subdivide there, or map to a "
                    "strip)",
                    map);
}

Status MapToTorus(const Surface& surface, const MapRequest& request, const SolveControl& control,
                  SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  Status status = CheckTopology(t, 0, "torus", "a closed surface of genus 1");
  if (!status.ok()) return status;
  ParameterizeRequest flat = {request.options, FreeBoundaryTargets(t)};
  flat.place_exact = PutOnTorus;
  if (status = Parameterize(surface, flat, control, map); !status.ok()) return status;
  const auto torus = UnrollTorus(t, map->cut, map->flat.on_input.angles, map->uv);
  if (!torus.ok()) return torus.status();
  PeriodicSummary& summary = Fill(&map->certificate.periodic);
  summary.modulus_real = torus->tau.real();
  summary.modulus_imaginary = torus->tau.imag();
  summary.period_mismatch = torus->mismatch;
  return PutCorners(surface, torus->place, "doubles cannot hold the torus with its seams exact",
                    map);
}

}  // namespace cirque

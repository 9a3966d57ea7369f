#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/core/count.h"
#include "cirque/core/solve_summary.h"
#include "cirque/domains/built_in_domains.h"
#include "cirque/domains/corner_places.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/packing.h"
#include "cirque/layout/seams.h"
#include "cirque/math/lattice.h"
#include "cirque/math/moebius.h"

namespace cirque {
namespace {

constexpr int kGridBits = 44;         ///< below the image's size: sums with periods are exact
constexpr double kWholeCover = 1e-6;  ///< relative: of the lattice's cell by the image

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

/// Where the layout has the corners.
std::vector<Complex> PlacesOfCorners(const CornerUv& uv) {
  std::vector<Complex> place;
  for (const Eigen::Vector2d& p : uv.value) place.emplace_back(p.x(), p.y());
  return place;
}

/// What leads across the seams of the cut, one translation a seam.
std::vector<Complex> SeamTranslations(const SurfaceMap& map, const Triangulation& t) {
  const SeamReport report = MeasureSeams(t, map.cut, {}, map.flat.on_input.angles, map.uv);
  std::vector<Complex> translations;
  for (const Seam& seam : report.seams) {
    translations.emplace_back(seam.translation.x(), seam.translation.y());
  }
  return translations;
}

/// Makes the places of every vertex differ by whole periods exactly, which are on the grid: so are then
/// the places on the cut. Returns the largest distance that one was moved by. `cyclic`: only the first
/// period is one.
double MakeExact(const Triangulation& t, const Lattice& lattice, bool cyclic, int grid,
                 std::vector<Complex>* place) {
  std::vector<Index> first(t.num_vertices, kNone);
  std::vector<bool> several(t.num_vertices, false);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    Index& corner = first[t.vertex[h]];
    if (corner == kNone) corner = h;
    if ((*place)[h] != (*place)[corner]) several[t.vertex[h]] = true;
  }
  const auto on_grid = [&](Complex z) {
    return Complex(RoundToGrid(z.real(), grid), RoundToGrid(z.imag(), grid));
  };
  const std::vector<Complex> before = *place;
  double moved = 0;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index v = t.vertex[h];
    if (!several[v]) continue;
    auto [a, b] = lattice.Coordinates(before[h] - before[first[v]]);
    a = std::round(a), b = cyclic ? 0 : std::round(b);
    const Complex base = on_grid(before[first[v]]);
    (*place)[h] = {base.real() + a * lattice.first.real() + b * lattice.second.real(),
                   base.imag() + a * lattice.first.imag() + b * lattice.second.imag()};
    moved = std::max(moved, std::abs((*place)[h] - before[h]));
  }
  return moved;
}

/// A strip of height 1, its bottom the longer boundary loop.
struct Strip {
  std::vector<Complex> place;  ///< of corners
  double period = 0;
  double mismatch = 0;  ///< of seams, before it was exact
};

/// Flattens and lays out with both boundaries straight.
Status MapToCylinder(const Surface& surface, const MapRequest& request, const SolveControl& control,
                     SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  ConeTargets straight = FreeBoundaryTargets(t);
  const std::vector<bool> boundary = BoundaryVertices(t);
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (boundary[v]) straight.lower[v] = straight.upper[v] = kPi;
  }
  return Parameterize(surface, {request.options, std::move(straight), {}, {}}, control, map);
}

/// The loops, the longer one first.
std::vector<std::vector<Index>> LoopsByLength(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  std::vector<std::vector<Index>> loops = BoundaryLoops(t);
  const auto length = [&](const std::vector<Index>& loop) {
    double sum = 0;
    for (const Index h : loop) sum += lengths.value[t.edge[h]];
    return sum;
  };
  if (length(loops[1]) > length(loops[0])) std::swap(loops[0], loops[1]);
  return loops;
}

/// Turns and scales the layout so that the longer loop runs along the x axis and the other one at
/// height 1, and makes that and the period exact.
Strip UnrollStrip(const Surface& surface, const SurfaceMap& map) {
  const Triangulation& t = surface.triangulation;
  const std::vector<std::vector<Index>> loops = LoopsByLength(surface);
  Strip strip{PlacesOfCorners(map.uv)};
  std::vector<Complex>& z = strip.place;
  const auto run = [&](Index h) { return z[Triangulation::Prev(h)] - z[Triangulation::Next(h)]; };
  Complex period = 0;
  for (const Index h : loops[0]) period += run(h);
  for (Complex& p : z) p /= period;
  const auto height = [&](const std::vector<Index>& loop) {
    double sum = 0;
    for (const Index h : loop) sum += z[Triangulation::Next(h)].imag();
    return sum / static_cast<double>(loop.size());
  };
  const double bottom = height(loops[0]), scale = 1 / (height(loops[1]) - bottom);
  double left = z[0].real();
  for (const Complex& p : z) left = std::min(left, p.real());
  for (Complex& p : z) p = scale * (p - Complex(left, bottom));
  std::vector<double> level(t.num_vertices, -1);
  for (int side = 0; side < 2; ++side) {
    for (const Index h : loops[side]) level[t.Tail(h)] = side;
  }
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (level[t.vertex[h]] >= 0) z[h].imag(level[t.vertex[h]]);
  }
  const int grid = std::ilogb(std::max(1.0, scale)) - kGridBits;
  strip.period = RoundToGrid(scale, grid);
  strip.mismatch = MakeExact(t, {strip.period, Complex(0, 1)}, true, grid, &z);
  return strip;
}

StatusOr<Strip> MapToStripOf(const Surface& surface, const char* domain, const MapRequest& request,
                             const SolveControl& control, SurfaceMap* map) {
  Status status = CheckTopology(surface.triangulation, 2, domain,
                                "a surface of genus 0 with two boundary loops");
  if (status.ok()) status = MapToCylinder(surface, request, control, map);
  if (!status.ok()) return status;
  Strip strip = UnrollStrip(surface, *map);
  PeriodicSummary& summary = Fill(&map->certificate.periodic);
  summary.annulus_modulus = 1 / strip.period;
  summary.period_mismatch = strip.mismatch;
  return strip;
}

/// Winds the strip round: every vertex once, its boundary on the circles.
std::vector<Complex> WindRound(const Triangulation& t, const Strip& strip,
                               PeriodicSummary* summary) {
  const double inner = std::exp(-2 * kPi / strip.period);
  std::vector<Complex> place(t.num_vertices), result(t.num_halfedges());
  std::vector<bool> placed(t.num_vertices, false);
  const std::vector<bool> boundary = BoundaryVertices(t);
  double error = 0;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index v = t.vertex[h];
    if (!placed[v]) {
      const Complex z = strip.place[h];
      const double radius = z.imag() == 1 ? inner : std::exp(-2 * kPi * z.imag() / strip.period);
      place[v] = std::polar(radius, 2 * kPi * z.real() / strip.period);
      placed[v] = true;
      if (boundary[v]) error = std::max(error, std::abs(std::abs(place[v]) / radius - 1));
    }
    result[h] = place[v];
  }
  summary->inner_radius = inner;
  summary->circle_error = error;
  return result;
}

/// The lattice of the torus, from what leads across the seams.
StatusOr<Lattice> LatticeOf(const Triangulation& t, const SurfaceMap& map) {
  const double area = AreaOf(map.uv);
  const std::vector<Complex> seams = SeamTranslations(map, t);
  for (std::size_t i = 0; i < seams.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double cell = std::abs((std::conj(seams[i]) * seams[j]).imag());
      if (std::abs(cell - area) <= kWholeCover * area) return ReduceLattice(seams[i], seams[j]);
    }
  }
  return Status(StatusCode::kNotConverged,
                "the seams of the torus lead to no lattice whose cell is the image");
}

}  // namespace

Status MapToStrip(const Surface& surface, const MapRequest& request, const SolveControl& control,
                  SurfaceMap* map) {
  const StatusOr<Strip> strip = MapToStripOf(surface, "strip", request, control, map);
  if (!strip.ok()) return strip.status();
  map->certificate.periodic->strip_period = strip->period;
  return PutCorners(surface, strip->place, "doubles cannot hold the strip with its seam exact",
                    map);
}

Status MapToAnnulus(const Surface& surface, const MapRequest& request, const SolveControl& control,
                    SurfaceMap* map) {
  const StatusOr<Strip> strip = MapToStripOf(surface, "annulus", request, control, map);
  if (!strip.ok()) return strip.status();
  const Triangulation& t = surface.triangulation;
  const std::vector<Complex> place = WindRound(t, *strip, &*map->certificate.periodic);
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
  const ParameterizeRequest flat = {request.options, FreeBoundaryTargets(t), {}, {}};
  if (status = Parameterize(surface, flat, control, map); !status.ok()) return status;
  const StatusOr<Lattice> lattice = LatticeOf(t, *map);
  if (!lattice.ok()) return lattice.status();
  std::vector<Complex> place = PlacesOfCorners(map->uv);
  for (Complex& z : place) z /= lattice->first;
  Eigen::Vector2d low(place[0].real(), place[0].imag());
  for (const Complex& z : place) low = low.cwiseMin(Eigen::Vector2d(z.real(), z.imag()));
  for (Complex& z : place) z -= Complex(low.x(), low.y());
  const Complex tau = lattice->Tau();
  const int grid = std::ilogb(std::max(1.0, std::abs(tau))) - kGridBits;
  const Complex exact = {RoundToGrid(tau.real(), grid), RoundToGrid(tau.imag(), grid)};
  PeriodicSummary& summary = Fill(&map->certificate.periodic);
  summary.modulus_real = exact.real();
  summary.modulus_imaginary = exact.imag();
  summary.period_mismatch = MakeExact(t, {1, exact}, false, grid, &place);
  return PutCorners(surface, place, "doubles cannot hold the torus with its seams exact", map);
}

}  // namespace cirque

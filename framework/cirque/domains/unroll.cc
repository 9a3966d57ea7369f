#include "cirque/domains/unroll.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cirque/layout/packing.h"
#include "cirque/layout/seams.h"
#include "cirque/math/lattice.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

constexpr int kGridBits = 44;         ///< below the image's size: sums with periods are exact
constexpr double kWholeCover = 1e-6;  ///< relative: of the lattice's cell by the image

std::vector<Complex> PlacesOfCorners(const CornerUv& uv) {
  std::vector<Complex> place;
  for (const Eigen::Vector2d& p : uv.value) place.emplace_back(p.x(), p.y());
  return place;
}

int GridOf(double size) { return std::ilogb(std::max(1.0, size)) - kGridBits; }

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

/// The two loops, that through `bottom` first.
std::vector<std::vector<Index>> LoopsFromBottom(const Triangulation& t, Index bottom) {
  std::vector<std::vector<Index>> loops = BoundaryLoops(t);
  const bool is_first =
      std::any_of(loops[0].begin(), loops[0].end(), [&](Index h) { return t.Tail(h) == bottom; });
  if (!is_first) std::swap(loops[0], loops[1]);
  return loops;
}

/// The periods, from what leads across the seams.
StatusOr<Lattice> LatticeOf(const Triangulation& t, const Cut& cut, const CornerAngles& angles,
                            const CornerUv& uv) {
  const double area = AreaOf(uv);
  std::vector<Complex> seams;
  for (const Seam& seam : MeasureSeams(t, cut, {}, angles, uv).seams) {
    seams.emplace_back(seam.translation.x(), seam.translation.y());
  }
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

Index VertexOnLongerLoop(const Triangulation& t, const EdgeLengths& lengths) {
  const std::vector<std::vector<Index>> loops = BoundaryLoops(t);
  const auto length = [&](const std::vector<Index>& loop) {
    double sum = 0;
    for (const Index h : loop) sum += lengths.value[t.edge[h]];
    return sum;
  };
  return t.Tail(loops[length(loops[1]) > length(loops[0]) ? 1 : 0].front());
}

Strip UnrollStrip(const Triangulation& t, const CornerUv& uv, Index bottom) {
  const std::vector<std::vector<Index>> loops = LoopsFromBottom(t, bottom);
  Strip strip{PlacesOfCorners(uv)};
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
  const double low = height(loops[0]), scale = 1 / (height(loops[1]) - low);
  double left = z[0].real();
  for (const Complex& p : z) left = std::min(left, p.real());
  for (Complex& p : z) p = scale * (p - Complex(left, low));
  std::vector<double> level(t.num_vertices, -1);
  for (int side = 0; side < 2; ++side) {
    for (const Index h : loops[side]) level[t.Tail(h)] = side;
  }
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (level[t.vertex[h]] >= 0) z[h].imag(level[t.vertex[h]]);
  }
  strip.grid = GridOf(scale);
  strip.period = RoundToGrid(scale, strip.grid);
  strip.mismatch = MakeExact(t, {strip.period, Complex(0, 1)}, true, strip.grid, &z);
  return strip;
}

double InnerRadius(const Strip& strip) { return std::exp(-2 * kPi / strip.period); }

std::vector<Complex> WindRound(const Triangulation& t, const Strip& strip) {
  std::vector<Complex> place(t.num_vertices), result(t.num_halfedges());
  std::vector<bool> placed(t.num_vertices, false);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index v = t.vertex[h];
    if (!placed[v]) {
      const Complex z = strip.place[h];
      const double radius =
          z.imag() == 1 ? InnerRadius(strip) : std::exp(-2 * kPi * z.imag() / strip.period);
      place[v] = std::polar(radius, 2 * kPi * z.real() / strip.period);
      placed[v] = true;
    }
    result[h] = place[v];
  }
  return result;
}

StatusOr<UnrolledTorus> UnrollTorus(const Triangulation& t, const Cut& cut,
                                    const CornerAngles& angles, const CornerUv& uv) {
  const StatusOr<Lattice> lattice = LatticeOf(t, cut, angles, uv);
  if (!lattice.ok()) return lattice.status();
  UnrolledTorus torus{PlacesOfCorners(uv)};
  std::vector<Complex>& place = torus.place;
  for (Complex& z : place) z /= lattice->first;
  Eigen::Vector2d low(place[0].real(), place[0].imag());
  for (const Complex& z : place) low = low.cwiseMin(Eigen::Vector2d(z.real(), z.imag()));
  for (Complex& z : place) z -= Complex(low.x(), low.y());
  const Complex tau = lattice->Tau();
  torus.grid = GridOf(std::abs(tau));
  torus.tau = {RoundToGrid(tau.real(), torus.grid), RoundToGrid(tau.imag(), torus.grid)};
  torus.mismatch = MakeExact(t, {1, torus.tau}, false, torus.grid, &place);
  return torus;
}

}  // namespace cirque

#include "experiments/studies/accuracy_cases.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <map>
#include <random>

#include <fmt/format.h>

#include "cirque/domains/domain.h"
#include "cirque/generators/generators.h"
#include "cirque/generators/known_maps.h"
#include "cirque/math/moebius.h"
#include "cirque/mesh/preflight.h"

namespace cirque {
namespace {

StatusOr<Surface> SurfaceOf(const PolygonSoup& soup) {
  PreflightReport report;
  return Preflight(soup, &report);
}

/// Triangles over the cells (i, j) of a lattice that `has` names, all diagonals through lattice
/// points of even i + j, where `place` puts the points; inner points are moved a little.
struct Lattice {
  std::function<bool(int, int)> has;
  std::function<Eigen::Vector2d(double, double)> place;
  int width = 0, height = 0;
};

PolygonSoup MeshOf(const Lattice& lattice, std::map<std::pair<int, int>, Index>* number) {
  PolygonSoup soup;
  std::mt19937 random(1);
  const auto jitter = [&] { return 0.4 * (static_cast<double>(random()) / 0x1p32 - 0.5); };
  const auto vertex = [&](int i, int j) {
    const auto [found, is_new] = number->try_emplace({i, j}, soup.position.size());
    if (!is_new) return found->second;
    const bool inner = lattice.has(i, j) && lattice.has(i - 1, j) && lattice.has(i, j - 1) &&
                       lattice.has(i - 1, j - 1);
    const double x = i + (inner ? jitter() : 0), y = j + (inner ? jitter() : 0);
    const Eigen::Vector2d p = lattice.place(x, y);
    soup.position.emplace_back(p.x(), p.y(), 0);
    return found->second;
  };
  const auto add = [&](Index a, Index b, Index c) {
    soup.corner.insert(soup.corner.end(), {a, b, c});
    soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
  };
  for (int j = 0; j < lattice.height; ++j) {
    for (int i = 0; i < lattice.width; ++i) {
      if (!lattice.has(i, j)) continue;
      const Index a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                  d = vertex(i, j + 1);
      const bool rising = (i + j) % 2 == 0;
      add(a, b, rising ? c : d);
      add(rising ? a : b, c, d);
    }
  }
  return soup;
}

Quadrilateral LShapeWithCorners(int n, const std::vector<std::pair<int, int>>& corners,
                                double modulus) {
  const Lattice lattice = {
      [n](int i, int j) {
        return i >= 0 && j >= 0 && std::min(i, j) < n && std::max(i, j) < 2 * n;
      },
      [n](double x, double y) { return Eigen::Vector2d(x / n, y / n); }, 2 * n, 2 * n};
  std::map<std::pair<int, int>, Index> number;
  Quadrilateral result;
  result.soup = MeshOf(lattice, &number);
  for (const auto& [x, y] : corners) result.corners.push_back(number.at({x * n, y * n}));
  result.modulus = modulus;
  return result;
}

/// Complete elliptic integral of the first kind, by the arithmetic-geometric mean.
double EllipticK(double k) {
  double a = 1, b = std::sqrt(1 - k * k);
  while (std::abs(a - b) > 1e-15) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return kPi / (2 * a);
}

/// The vertex at this part of the way round the boundary.
Index BoundaryVertex(const Triangulation& t, double part) {
  const std::vector<Index> loop = BoundaryLoops(t).front();
  return t.Tail(loop[static_cast<std::size_t>(part * static_cast<double>(loop.size()))]);
}

}  // namespace

StatusOr<AccuracyRow> DiskError(const DiskCase& disk) {
  const auto soup = GenerateMesh(disk.generator, {disk.triangles, 1});
  const auto known = KnownConformalMaps().Find(disk.generator);
  if (!soup.ok() || !known.ok()) return soup.ok() ? known.status() : soup.status();
  const auto surface = SurfaceOf(*soup);
  if (!surface.ok()) return surface.status();
  MapRequest request;
  request.domain = "disk";
  request.options.refine_map = disk.refine_map;
  if (disk.pole >= 0) request.shape.pole = BoundaryVertex(surface->triangulation, disk.pole);
  const StatusOr<SurfaceMap> map = MapSurface(*surface, request);
  if (!map.ok()) return map.status();
  const Triangulation& t = surface->triangulation;
  std::vector<Complex> exact, found(t.num_vertices);
  for (const Eigen::Vector3d& p : surface->position) {
    const Eigen::Vector2d w = known->to_plane(p) / disk.radius;
    exact.emplace_back(w.x(), w.y());
  }
  Index centre = kNone;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index v = t.vertex[h];
    found[v] = {map->uv.value[h].x(), map->uv.value[h].y()};
    if (found[v] == Complex(0)) centre = v;
  }
  const Moebius centring = Moebius::DiskAutomorphism(exact[centre]);
  Complex turn = 0;
  for (Index v = 0; v < t.num_vertices; ++v) {
    exact[v] = centring(exact[v]).value;
    turn += found[v] * std::conj(exact[v]);
  }
  turn /= std::abs(turn);
  double sum = 0;
  for (Index v = 0; v < t.num_vertices; ++v) sum += std::norm(found[v] - turn * exact[v]);
  const double rms = std::sqrt(sum / t.num_vertices);
  return AccuracyRow{t.num_faces(), rms, rms};
}

Quadrilateral AnnulusSector(int n, double ratio, double angle) {
  const Lattice lattice = {[n](int i, int j) { return i >= 0 && j >= 0 && i < n && j < n; },
                           [=](double x, double y) {
                             const Complex z = std::polar(std::pow(ratio, x / n), angle * y / n);
                             return Eigen::Vector2d(z.real(), z.imag());
                           },
                           n, n};
  std::map<std::pair<int, int>, Index> number;
  Quadrilateral result;
  result.soup = MeshOf(lattice, &number);
  result.corners = {number.at({0, 0}), number.at({n, 0}), number.at({n, n}), number.at({0, n})};
  result.modulus = std::log(ratio) / angle;
  return result;
}

Quadrilateral LShape(int n) {
  return LShapeWithCorners(n, {{2, 0}, {1, 2}, {0, 2}, {0, 0}}, std::sqrt(3.0));
}

Quadrilateral LShapeBetweenEnds(int n) {
  const double k = std::sqrt(0.75);
  return LShapeWithCorners(n, {{2, 0}, {2, 1}, {1, 2}, {0, 2}},
                           EllipticK(0.5) / (2 * EllipticK(k)));
}

StatusOr<AccuracyRow> ModulusError(const Quadrilateral& quadrilateral) {
  const auto surface = SurfaceOf(quadrilateral.soup);
  if (!surface.ok()) return surface.status();
  MapRequest request;
  request.domain = "rectangle";
  request.shape.corners = quadrilateral.corners;  // as in the file: no vertex is isolated
  const StatusOr<SurfaceMap> map = MapSurface(*surface, request);
  if (!map.ok()) return map.status();
  const double modulus = *map->certificate.polygon->conformal_modulus;
  return AccuracyRow{surface->triangulation.num_faces(), modulus,
                     std::abs(modulus - quadrilateral.modulus)};
}

std::string AccuracyTable(const std::string& title, const std::string& value,
                          const std::vector<AccuracyRow>& rows) {
  const bool is_error = rows.front().value == rows.front().error;
  std::string text = fmt::format("\n### {}\n\n| triangles | {} |{} order |\n|--:|--:|{}--:|\n",
                                 title, value, is_error ? "" : " error |", is_error ? "" : "--:|");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const AccuracyRow& row = rows[i];
    text += is_error ? fmt::format("| {} | {:.3e} |", row.triangles, row.value)
                     : fmt::format("| {} | {:.9f} | {:.2e} |", row.triangles, row.value, row.error);
    // Edge lengths go with the root of the number of triangles.
    const double refinement =
        i == 0 ? 0 : 0.5 * std::log(static_cast<double>(row.triangles) / rows[i - 1].triangles);
    text += i == 0
                ? " |\n"
                : fmt::format(" {:.2f} |\n", std::log(rows[i - 1].error / row.error) / refinement);
  }
  return text;
}

}  // namespace cirque

#include "tests/layout/flat_surfaces.h"

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include <glog/logging.h>

#include "cirque/intrinsic/intrinsic_surface.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Cell = std::array<int, 4>;  // a sheet and integer coordinates

/// Triangles on cells; every cell becomes a vertex where it is first named.
class SoupBuilder {
 public:
  void AddTriangle(const Cell& a, const Cell& b, const Cell& c) {
    for (const Cell& cell : {a, b, c}) {
      const auto [at, is_new] = vertex_.emplace(cell, static_cast<Index>(vertex_.size()));
      if (is_new) soup_.position.emplace_back(cell[1], cell[2], cell[3]);
      soup_.corner.push_back(at->second);
    }
    soup_.first_corner.push_back(static_cast<Index>(soup_.corner.size()));
  }

  void AddSquare(const std::array<Cell, 4>& cell, bool other_diagonal = false) {
    const int k = other_diagonal ? 1 : 0;
    AddTriangle(cell[k], cell[k + 1], cell[k + 2]);
    AddTriangle(cell[k], cell[k + 2], cell[(k + 3) % 4]);
  }

  /// Positions are the coordinates, moved apart by sheets.
  Surface Build() const { return SurfaceOf(soup_); }

 private:
  PolygonSoup soup_;
  std::map<Cell, Index> vertex_;
};

KnownFlatSurface WithLengths(Surface surface, const std::function<double(double, double)>& length) {
  KnownFlatSurface flat;
  const Triangulation& t = surface.triangulation;
  flat.lengths.value.resize(t.num_edges());
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    const Eigen::Vector3d edge = surface.position[t.Tip(h)] - surface.position[t.Tail(h)];
    flat.lengths.value[e] = length ? length(edge.x(), edge.y()) : edge.norm();
  }
  flat.angles = MeasureCornerAngles(t, flat.lengths);
  flat.cones = MeasuredCones(t, flat.angles);
  flat.surface = std::move(surface);
  return flat;
}

/// A grid whose x, and y if asked for, count modulo n and m.
KnownFlatSurface PeriodicGrid(int n, int m, bool wrap_y) {
  SoupBuilder builder;
  const auto cell = [&](int x, int y) { return Cell{0, x % n, wrap_y ? y % m : y, 0}; };
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < m; ++y) {
      builder.AddSquare({cell(x, y), cell(x + 1, y), cell(x + 1, y + 1), cell(x, y + 1)});
    }
  }
  const auto modulo = [](double d, int period) { return std::remainder(d, period); };
  return WithLengths(builder.Build(), [=](double dx, double dy) {
    return std::hypot(modulo(dx, n), wrap_y ? modulo(dy, m) : dy);
  });
}

}  // namespace

std::vector<Index> MeasuredCones(const Triangulation& t, const CornerAngles& angles) {
  std::vector<double> sum(t.num_vertices, 0);
  for (Index c = 0; c < t.num_halfedges(); ++c) sum[t.vertex[c]] += angles.value[c];
  const std::vector<bool> boundary = BoundaryVertices(t);
  std::vector<Index> cones;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (!boundary[v] && std::abs(sum[v] - 2 * kPi) > 1e-6) cones.push_back(v);
  }
  return cones;
}

KnownFlatSurface FlatCube(int n) {
  SoupBuilder builder;
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const auto cell = [&](int a, int b, int c) {
          Cell result = {0, 0, 0, 0};
          result[1 + axis] = c;
          result[1 + (axis + 1) % 3] = a;
          result[1 + (axis + 2) % 3] = b;
          return result;
        };
        builder.AddSquare(
            {cell(i, j, n), cell(i + 1, j, n), cell(i + 1, j + 1, n), cell(i, j + 1, n)});
        builder.AddSquare(
            {cell(i, j, 0), cell(i, j + 1, 0), cell(i + 1, j + 1, 0), cell(i + 1, j, 0)});
      }
    }
  }
  return WithLengths(builder.Build(), nullptr);
}

KnownFlatSurface FlatOctahedron(int n) {
  SoupBuilder builder;
  for (int octant = 0; octant < 8; ++octant) {
    const int x = octant & 1 ? -1 : 1, y = octant & 2 ? -1 : 1, z = octant & 4 ? -1 : 1;
    const auto cell = [&](int i, int j) { return Cell{0, x * i, y * j, z * (n - i - j)}; };
    const auto add = [&](const Cell& a, const Cell& b, const Cell& c) {
      x* y* z > 0 ? builder.AddTriangle(a, b, c) : builder.AddTriangle(a, c, b);
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        add(cell(i, j), cell(i + 1, j), cell(i, j + 1));
        if (i + j + 1 < n) add(cell(i + 1, j), cell(i + 1, j + 1), cell(i, j + 1));
      }
    }
  }
  return WithLengths(builder.Build(), nullptr);
}

KnownFlatSurface FlatPillow(int n, int m) {
  SoupBuilder builder;
  for (const int sheet : {0, 1}) {
    const auto cell = [&](int x, int y) {
      const bool sewn = x == 0 || y == 0 || x == n || y == m;
      return Cell{sewn ? 0 : sheet, x, y, 0};
    };
    for (int x = 0; x < n; ++x) {
      for (int y = 0; y < m; ++y) {
        std::array<Cell, 4> square = {cell(x, y), cell(x + 1, y), cell(x + 1, y + 1),
                                      cell(x, y + 1)};
        // The back is turned around; its diagonals are the other ones, or corners would share them.
        if (sheet == 1) std::swap(square[1], square[3]);
        builder.AddSquare(square, sheet == 1);
      }
    }
  }
  return WithLengths(builder.Build(), nullptr);
}

KnownFlatSurface FlatCylinder(int n, int m) { return PeriodicGrid(n, m, false); }

KnownFlatSurface FlatTorus(int n, int m) { return PeriodicGrid(n, m, true); }

}  // namespace cirque

#include "experiments/studies/small_surfaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glog/logging.h>

#include "cirque/core/triangulation.h"
#include "cirque/generators/generators.h"

namespace cirque {

double Dice::Power(double least_exponent, double most_exponent) {
  return std::pow(10, Uniform(least_exponent, most_exponent));
}

namespace {

void AddTriangle(Index a, Index b, Index c, PolygonSoup* soup) {
  CHECK_EQ(AddPolygon({a, b, c}, soup), "");
}

/// A quadrilateral, split along either diagonal.
void AddQuadrilateral(Index a, Index b, Index c, Index d, Dice* dice, PolygonSoup* soup) {
  if (dice->Chance(0.5)) {
    std::swap(a, b);
    std::swap(b, c);
    std::swap(c, d);
  }
  AddTriangle(a, b, c, soup);
  AddTriangle(a, c, d, soup);
}

// Numbers for the arguments of one call are drawn before it, the last argument's first: a compiler may
// evaluate them in any order, and GCC's, in which the surfaces were first drawn, is that one.

/// A grid of `columns` x `rows` squares, its vertices off their places; around: its first column is
/// its last.
PolygonSoup Grid(int columns, int rows, bool around, bool over, Dice* dice) {
  const int width = around ? columns : columns + 1, height = over ? rows : rows + 1;
  const double jitter = dice->Uniform(0, 0.45), relief = dice->Power(-2, 0.5);
  PolygonSoup soup;
  const auto noise = [&] { return dice->Uniform(-1, 1); };
  for (int v = 0; v < width * height; ++v) {
    const double z = relief * noise();
    const double y = v / width + jitter * noise();
    const double x = v % width + jitter * noise();
    soup.position.emplace_back(x, y, z);
  }
  const auto vertex = [&](int x, int y) { return (y % height) * width + x % width; };
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      AddQuadrilateral(vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1), dice,
                       &soup);
    }
  }
  return soup;
}

PolygonSoup Patch(Dice* dice) {
  const int rows = dice->Between(1, 7), columns = dice->Between(1, 7);
  return Grid(columns, rows, false, false, dice);
}

/// A vertex almost on one of its neighbours, or on the line to it.
PolygonSoup Needle(Dice* dice) {
  PolygonSoup soup = Patch(dice);
  const int p = dice->Below(soup.num_polygons()), k = dice->Below(3);
  const Eigen::Vector3d& from = soup.position[soup.corner[3 * p + k]];
  const Eigen::Vector3d& to = soup.position[soup.corner[3 * p + (k + 1) % 3]];
  const double left = dice->Power(-10, -1);
  Eigen::Vector3d& moved = soup.position[soup.corner[3 * p + (k + 2) % 3]];
  const Eigen::Vector3d place = dice->Chance(0.5) ? to : Eigen::Vector3d(0.5 * (from + to));
  moved = place + left * (moved - place);
  return soup;
}

/// Triangles about one vertex, all around it or not, their lengths over orders of magnitude.
PolygonSoup Fan(Dice* dice) {
  const int n = dice->Between(3, 60);
  const bool closed = dice->Chance(0.6);
  const double spread = dice->Uniform(0, 3), height = dice->Power(-3, 2);
  PolygonSoup soup;
  soup.position.emplace_back(0, 0, height);
  std::vector<double> angle(n);
  for (double& a : angle) a = dice->Uniform(0, closed ? 2 * kPi : 6);
  std::sort(angle.begin(), angle.end());
  for (const double a : angle) {
    const double radius = dice->Power(-spread, 0);
    soup.position.emplace_back(radius * std::cos(a), radius * std::sin(a), 0.1 * dice->Below(3));
  }
  for (int i = 1; i < n; ++i) AddTriangle(0, i, i + 1, &soup);
  if (closed) AddTriangle(0, n, 1, &soup);
  return soup;
}

/// Triangulates the polygon of vertices first to last by ears and chords.
void AddPolygonBetween(int first, int last, Dice* dice, PolygonSoup* soup) {
  if (last - first < 2) return;
  const int apex = dice->Between(first + 1, last - 1);
  AddTriangle(first, apex, last, soup);
  AddPolygonBetween(first, apex, dice, soup);
  AddPolygonBetween(apex, last, dice, soup);
}

/// A polygon without inner vertices: ears, chords, vertices of one triangle.
PolygonSoup Ears(Dice* dice) {
  const int n = dice->Between(3, 24);
  const double spread = dice->Uniform(0, 2);
  PolygonSoup soup;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * kPi * i / n, radius = dice->Power(-spread, 0);
    soup.position.emplace_back(radius * std::cos(a), radius * std::sin(a), dice->Uniform(0, 0.5));
  }
  AddPolygonBetween(0, n - 1, dice, &soup);
  return soup;
}

/// One vertex far away.
PolygonSoup Spike(Dice* dice) {
  PolygonSoup soup = Patch(dice);
  soup.position[dice->Below(static_cast<int>(soup.position.size()))].z() += dice->Power(0, 5);
  return soup;
}

/// All triangles slivers.
PolygonSoup Slivers(Dice* dice) {
  PolygonSoup soup = Patch(dice);
  const double squeeze = dice->Power(-8, -1);
  for (Eigen::Vector3d& point : soup.position) point.y() *= squeeze;
  return soup;
}

/// A ring, rolled up.
PolygonSoup Band(Dice* dice) {
  const int around = dice->Between(3, 12);
  PolygonSoup soup = Grid(around, dice->Between(1, 5), true, false, dice);
  for (Eigen::Vector3d& point : soup.position) {
    const double a = 2 * kPi * point.x() / around, radius = 1 + 0.3 * point.z();
    point = {radius * std::cos(a), radius * std::sin(a), point.y()};
  }
  return soup;
}

PolygonSoup Torus(Dice* dice) {
  const int n = dice->Between(3, 8), m = dice->Between(3, 8);
  PolygonSoup soup = Grid(n, m, true, true, dice);
  for (Eigen::Vector3d& point : soup.position) {
    const double a = 2 * kPi * point.x() / n, b = 2 * kPi * point.y() / m;
    const double radius = 2 + std::cos(b);
    point = {radius * std::cos(a), radius * std::sin(a), std::sin(b) + 0.1 * point.z()};
  }
  return soup;
}

/// Puts a vertex into some of the triangles: valence 3.
PolygonSoup Split(const PolygonSoup& soup, double probability, Dice* dice) {
  PolygonSoup split;
  split.position = soup.position;
  for (Index p = 0; p < soup.num_polygons(); ++p) {
    const Index* v = &soup.corner[3 * p];
    if (!dice->Chance(probability)) {
      AddTriangle(v[0], v[1], v[2], &split);
      continue;
    }
    const double a = dice->Uniform(0.05, 0.5), b = dice->Uniform(0.05, 0.4);
    const auto inner = static_cast<Index>(split.position.size());
    split.position.emplace_back(a * soup.position[v[0]] + b * soup.position[v[1]] +
                                (1 - a - b) * soup.position[v[2]]);
    for (int k = 0; k < 3; ++k) AddTriangle(v[k], v[(k + 1) % 3], inner, &split);
  }
  return split;
}

PolygonSoup SplitPatch(Dice* dice) {
  const double probability = dice->Uniform(0.1, 1);
  return Split(Patch(dice), probability, dice);
}

/// A tetrahedron or octahedron, split and crumpled.
PolygonSoup Polyhedron(Dice* dice) {
  PolygonSoup soup;
  const int n = dice->Between(3, 8);  // a double pyramid; below 3 around it a tetrahedron
  soup.position = {{0, 0, 1}, {0, 0, -1}};
  for (int i = 0; i < n; ++i) {
    soup.position.emplace_back(std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n), 0);
  }
  for (int i = 0; i < n; ++i) {
    const Index a = 2 + i, b = 2 + (i + 1) % n;
    AddTriangle(a, b, 0, &soup);
    AddTriangle(b, a, 1, &soup);
  }
  for (int rounds = dice->Below(3); rounds > 0; --rounds) soup = Split(soup, 0.3, dice);
  const double crumple = dice->Power(-3, 0);
  for (Eigen::Vector3d& point : soup.position) point *= 1 + crumple * dice->Uniform(-0.9, 2);
  return soup;
}

PolygonSoup Generated(Dice* dice) {
  const std::vector<std::string> names = MeshGenerators().Names();
  GeneratorOptions options;
  options.triangles = dice->Between(20, 300);
  options.seed = static_cast<unsigned>(dice->Below(1000000));
  const std::string& name = names[dice->Below(static_cast<int>(names.size()))];
  StatusOr<PolygonSoup> soup = GenerateMesh(name, options);
  CHECK(soup.ok()) << soup.status().message();
  return *std::move(soup);
}

}  // namespace

const std::vector<SmallSurfaceKind>& SmallSurfaceKinds() {
  static const std::vector<SmallSurfaceKind> kTable = {{"patch", Patch},
                                                       {"needle", Needle},
                                                       {"fan", Fan},
                                                       {"ears", Ears},
                                                       {"spike", Spike},
                                                       {"slivers", Slivers},
                                                       {"band", Band},
                                                       {"torus", Torus},
                                                       {"split patch", SplitPatch},
                                                       {"polyhedron", Polyhedron},
                                                       {"generated", Generated}};
  return kTable;
}

}  // namespace cirque

#include "tests/verify/fixtures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <gtest/gtest.h>

namespace cirque::verify {

MapReport Judge(const PolygonSoup& in, const PolygonSoup& out, const VerifyOptions& options) {
  const StatusOr<MapReport> report = VerifyMap(in, out, options);
  EXPECT_TRUE(report.ok()) << report.status().message();
  if (report.ok()) return *report;
  MapReport none;
  none.errors = {"no report"};
  return none;
}

PolygonSoup MakeSoup(std::vector<Eigen::Vector3d> position,
                     const std::vector<Triangle>& triangles) {
  PolygonSoup mesh;
  mesh.position = std::move(position);
  for (const Triangle& t : triangles) {
    mesh.corner.insert(mesh.corner.end(), t.begin(), t.end());
    mesh.first_corner.push_back(static_cast<Index>(mesh.corner.size()));
  }
  return mesh;
}

PolygonSoup WithVertexUv(PolygonSoup mesh, std::vector<Eigen::Vector2d> uv) {
  mesh.texture = std::move(uv);
  mesh.corner_texture = mesh.corner;
  return mesh;
}

PolygonSoup WithCornerUv(PolygonSoup mesh, std::vector<Eigen::Vector2d> uv) {
  mesh.texture = std::move(uv);
  mesh.corner_texture.resize(mesh.corner.size());
  std::iota(mesh.corner_texture.begin(), mesh.corner_texture.end(), 0);
  return mesh;
}

std::vector<Eigen::Vector2d> Flattened(const PolygonSoup& mesh) {
  std::vector<Eigen::Vector2d> flat;
  for (const Eigen::Vector3d& p : mesh.position) flat.push_back(p.head<2>());
  return flat;
}

PolygonSoup Sheet(int n) {
  std::vector<Eigen::Vector3d> position;
  std::vector<Triangle> triangles;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) position.emplace_back(i, j, 0.05 * (i * i + i * j));
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = c - 1;
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  }
  return MakeSoup(std::move(position), triangles);
}

PolygonSoup FlatSheet(int n) {
  PolygonSoup mesh = Sheet(n);
  for (Eigen::Vector3d& p : mesh.position) p.z() = 0;
  return mesh;
}

PolygonSoup SquareStrip(const std::vector<Cell>& walk) {
  std::vector<Eigen::Vector3d> position;
  std::vector<Triangle> triangles;
  std::map<Cell, Index> before;  // the corners of the cell before
  for (const auto& [x, y] : walk) {
    const std::array<Cell, 4> corners = {Cell(x, y), Cell(x + 1, y), Cell(x + 1, y + 1),
                                         Cell(x, y + 1)};
    std::map<Cell, Index> now;
    for (const Cell& corner : corners) {
      const auto found = before.find(corner);
      now[corner] = found != before.end() ? found->second : static_cast<Index>(position.size());
      if (found == before.end()) {
        position.emplace_back(corner.first, corner.second, 0.1 * static_cast<double>(now[corner]));
      }
    }
    triangles.push_back({now[corners[0]], now[corners[1]], now[corners[2]]});
    triangles.push_back({now[corners[0]], now[corners[2]], now[corners[3]]});
    before = std::move(now);
  }
  PolygonSoup mesh = MakeSoup(std::move(position), triangles);
  return WithVertexUv(mesh, Flattened(mesh));
}

PolygonSoup Fan(int n, double uv_step) {
  std::vector<Eigen::Vector3d> position = {Eigen::Vector3d::Zero()};
  std::vector<Triangle> triangles;
  std::vector<Eigen::Vector2d> uv;
  const bool closes = std::abs(std::remainder(uv_step * n, 2 * kPi)) < 1e-9;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * kPi * i / n;
    position.emplace_back(std::cos(angle), std::sin(angle), -0.3);
    triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
    const auto rim = [&](int k) {
      const double t = uv_step * (closes ? k % n : k);
      return Eigen::Vector2d(std::cos(t), std::sin(t));
    };
    uv.insert(uv.end(), {Eigen::Vector2d(0, 0), rim(i), rim(i + 1)});
  }
  return WithCornerUv(MakeSoup(std::move(position), triangles), std::move(uv));
}

}  // namespace cirque::verify

#include "experiments/transfer/move_values.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cirque/core/atomic_file.h"
#include "cirque/io/file_input.h"

namespace cirque {
namespace {

SurfacePoint CornerOf(const MapFile& map, std::size_t corner) {
  return {map.triangles.face[corner / 3], map.triangles.on_face[corner]};
}

SurfacePoint MiddleOf(const MapFile& map, std::size_t triangle) {
  const auto& at = map.triangles.on_face;
  return {map.triangles.face[triangle],
          (at[3 * triangle] + at[3 * triangle + 1] + at[3 * triangle + 2]) / 3};
}

/// Of a triangle of the map, on the surface.
double AreaOf(const MeshOfMaps& of, const MapFile& map, std::size_t triangle) {
  const Index* v = &of.surface.triangulation.vertex[3 * map.triangles.face[triangle]];
  Eigen::Vector3d at[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d& weight = map.triangles.on_face[3 * triangle + k];
    at[k] = weight[0] * of.surface.position[v[0]] + weight[1] * of.surface.position[v[1]] +
            weight[2] * of.surface.position[v[2]];
  }
  return 0.5 * (at[1] - at[0]).cross(at[2] - at[0]).norm();
}

}  // namespace

StatusOr<Eigen::MatrixXd> ReadValues(const std::string& path) {
  const StatusOr<std::string> content = ReadFileContent(path);
  if (!content.ok()) return content.status();
  TextScanner text(path, *content);
  std::vector<double> values;
  std::size_t columns = 0, rows = 0;
  for (; text.NextLine(); ++rows) {
    const std::size_t before = values.size();
    while (!text.AtLineEnd()) {
      const std::optional<double> number = text.Number();
      if (!number) return text.Expected("a number");
      values.push_back(*number);
    }
    const std::size_t count = values.size() - before;
    if (rows == 0) columns = count;
    if (count != columns) {
      return text.Error(fmt::format("{} numbers; the lines before have {}", count, columns));
    }
  }
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::MatrixXd(Eigen::Map<const Rows>(values.data(), static_cast<Eigen::Index>(rows),
                                                static_cast<Eigen::Index>(columns)));
}

Status WriteValues(const std::string& path, const Eigen::MatrixXd& values) {
  std::string text;
  for (Eigen::Index row = 0; row < values.rows(); ++row) {
    for (Eigen::Index column = 0; column < values.cols(); ++column) {
      text += fmt::format("{}{}", column == 0 ? "" : " ", values(row, column));
    }
    text += '\n';
  }
  return WriteFileAtomically(path, text);
}

Eigen::MatrixXd MoveVertexValues(const MapFile& from, const Eigen::MatrixXd& values,
                                 const MapFile& to) {
  const MapLocator locator(from.triangles);
  const auto count = static_cast<Eigen::Index>(to.mesh.position.size());
  Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(count, values.cols());
  const Eigen::Index same = std::min(count, values.rows());
  moved.topRows(same) = values.topRows(same);
  for (std::size_t c = 0; c < to.vertex.size(); ++c) {
    const MapLocator::Place place = locator.Find(CornerOf(to, c));
    if (place.triangle == kNone) continue;
    moved.row(to.vertex[c]).setZero();
    for (int k = 0; k < 3; ++k) {
      // Where a point is a vertex, its value alone counts, whatever the others are.
      if (place.weight[k] == 0) continue;
      moved.row(to.vertex[c]) +=
          place.weight[k] *
          values.row(from.vertex[static_cast<std::size_t>(3 * place.triangle + k)]);
    }
  }
  return moved;
}

Eigen::MatrixXd MoveFaceValues(const MeshOfMaps& of, const MapFile& from,
                               const Eigen::MatrixXd& values, const MapFile& to) {
  Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(to.mesh.num_polygons(), values.cols());
  std::vector<double> area(static_cast<std::size_t>(to.mesh.num_polygons()), 0);
  const auto add = [&](Index polygon, double weight, Index row) {
    moved.row(polygon) += weight * values.row(row);
    area[static_cast<std::size_t>(polygon)] += weight;
  };
  if (to.is_exact) {
    const MapLocator locator(from.triangles);
    for (std::size_t t = 0; t < to.polygon.size(); ++t) {
      const Index there = locator.Find(MiddleOf(to, t)).triangle;
      if (there != kNone) add(to.polygon[t], 1, from.polygon[static_cast<std::size_t>(there)]);
    }
  } else {
    for (std::size_t t = 0; t < from.polygon.size(); ++t) {
      const Index face = from.triangles.face[t];
      add(of.surface.soup_polygon[face], AreaOf(of, from, t), from.polygon[t]);
    }
  }
  for (Eigen::Index p = 0; p < moved.rows(); ++p) {
    const double whole = area[static_cast<std::size_t>(p)];
    if (whole > 0) moved.row(p) /= whole;
  }
  return moved;
}

}  // namespace cirque

#include "cirque/domains/transfer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glog/logging.h>

#include "cirque/core/grouping.h"
#include "cirque/core/parallel.h"

namespace cirque {
namespace {

using Vector = Eigen::Vector2d;

constexpr double kOnEdge = 1e-12;  ///< in barycentric coordinates

double Cross(const Vector& a, const Vector& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Barycentric coordinates of p in the triangle a b c.
Eigen::Vector3d Barycentric(const Vector& a, const Vector& b, const Vector& c, const Vector& p) {
  const Eigen::Vector3d areas(Cross(b - p, c - p), Cross(c - p, a - p), Cross(a - p, b - p));
  return areas / areas.sum();
}

/// The place of a coordinate between the centres of texels: the lower one, and how far to the next.
std::pair<int, double> Between(double share, int count) {
  const double at = std::clamp(share * count - 0.5, 0.0, static_cast<double>(count - 1));
  const int lower = std::min(static_cast<int>(at), std::max(count - 2, 0));
  return {lower, at - lower};
}

/// Gives texels beside those that have a value their mean; which they are then is in `has`.
void Dilate(std::vector<char>* has, Texture* texture) {
  const std::vector<char> before = *has;
  const int width = texture->width, height = texture->height, channels = texture->channels;
  const auto had = [&](int i, int j) {
    return i >= 0 && j >= 0 && i < width && j < height &&
           before[static_cast<std::size_t>(j) * width + i];
  };
  ParallelFor(height, [&](Index j) {
    for (int i = 0; i < width; ++i) {
      if (had(i, j)) continue;
      Eigen::VectorXd sum = Eigen::VectorXd::Zero(channels);
      int count = 0;
      for (int dj = -1; dj <= 1; ++dj) {
        for (int di = -1; di <= 1; ++di) {
          if (!had(i + di, j + dj)) continue;
          sum += Eigen::VectorXd::Map(texture->At(i + di, j + dj), channels);
          ++count;
        }
      }
      if (count == 0) continue;
      Eigen::VectorXd::Map(texture->At(i, j), channels) = sum / count;
      (*has)[static_cast<std::size_t>(j) * width + i] = 1;
    }
  });
}

}  // namespace

MappedTriangles TrianglesOf(const Triangulation& t, const CornerUv& uv) {
  MappedTriangles map;
  map.uv = uv.value;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    map.on_face.push_back(Eigen::Vector3d::Unit(h % 3));
    if (h % 3 == 0) map.face.push_back(Triangulation::Face(h));
  }
  return map;
}

MappedTriangles TrianglesOf(const Triangulation& t, const ExactMap& exact) {
  MappedTriangles map;
  map.face = exact.face_of_input;
  for (std::size_t c = 0; c < exact.corner.size(); ++c) {
    map.uv.push_back(exact.uv[exact.corner_uv[c]]);
    map.on_face.push_back(InFace(t, exact.point[exact.corner[c]], map.face[c / 3]));
  }
  return map;
}

struct MapLocator::Grid {
  explicit Grid(MappedTriangles triangles);

  Index CellOf(const Vector& uv, int axis) const {
    const double side = box.sizes()[axis];
    const double share = side > 0 ? (uv[axis] - box.min()[axis]) / side : 0;
    return static_cast<Index>(std::clamp(share * cells, 0.0, cells - 1.0));
  }

  MappedTriangles map;
  Buckets in_cell, in_face;
  Eigen::AlignedBox2d box;
  Index cells;  // along either axis
};

MapLocator::Grid::Grid(MappedTriangles triangles) : map(std::move(triangles)) {
  const Index count = map.num_triangles();
  CHECK_GT(count, 0);
  for (const Vector& uv : map.uv) box.extend(uv);
  cells = std::max<Index>(1, static_cast<Index>(std::sqrt(count)));
  in_face = SortIntoBuckets(map.face, *std::max_element(map.face.begin(), map.face.end()) + 1);
  std::vector<Index> cell, triangle;
  for (Index t = 0; t < count; ++t) {
    Eigen::AlignedBox2d around;
    for (Index c = 3 * t; c < 3 * t + 3; ++c) around.extend(map.uv[c]);
    for (Index j = CellOf(around.min(), 1); j <= CellOf(around.max(), 1); ++j) {
      for (Index i = CellOf(around.min(), 0); i <= CellOf(around.max(), 0); ++i) {
        cell.push_back(j * cells + i);
        triangle.push_back(t);
      }
    }
  }
  in_cell = SortIntoBuckets(cell, cells * cells);
  for (Index& item : in_cell.item) item = triangle[item];
}

MapLocator::MapLocator(MappedTriangles map) : grid_(std::make_shared<const Grid>(std::move(map))) {}

const Eigen::AlignedBox2d& MapLocator::box() const { return grid_->box; }

std::optional<SurfacePoint> MapLocator::PointAt(const Vector& uv) const {
  const MappedTriangles& map = grid_->map;
  const Buckets& in_cell = grid_->in_cell;
  const Index cell = grid_->CellOf(uv, 1) * grid_->cells + grid_->CellOf(uv, 0);
  double inside = -kOnEdge;
  std::optional<SurfacePoint> point;
  for (Index i = in_cell.first[cell]; i < in_cell.first[cell + 1]; ++i) {
    const Index t = in_cell.item[i];
    const Eigen::Vector3d weight =
        Barycentric(map.uv[3 * t], map.uv[3 * t + 1], map.uv[3 * t + 2], uv);
    if (!(weight.minCoeff() >= inside)) continue;
    inside = weight.minCoeff();
    Eigen::Vector3d on_face = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) on_face += std::max(weight[k], 0.0) * map.on_face[3 * t + k];
    point = {map.face[t], on_face / on_face.sum()};
  }
  return point;
}

MapLocator::Place MapLocator::Find(const SurfacePoint& point) const {
  const auto in_face = [](const Eigen::Vector3d& barycentric) -> Vector {
    return {barycentric[1], barycentric[2]};
  };
  const MappedTriangles& map = grid_->map;
  const Buckets& of_face = grid_->in_face;
  Place place;
  if (point.face + 1 >= static_cast<Index>(of_face.first.size())) return place;
  double inside = -std::numeric_limits<double>::infinity();
  for (Index i = of_face.first[point.face]; i < of_face.first[point.face + 1]; ++i) {
    const Index t = of_face.item[i], c = 3 * t;
    const Eigen::Vector3d weight =
        Barycentric(in_face(map.on_face[c]), in_face(map.on_face[c + 1]),
                    in_face(map.on_face[c + 2]), in_face(point.barycentric));
    if (!(weight.minCoeff() > inside)) continue;
    inside = weight.minCoeff();
    place = {t, weight};
  }
  return place;
}

Vector MapLocator::UvAt(const SurfacePoint& point) const {
  const Place place = Find(point);
  Vector uv = Vector::Zero();
  if (place.triangle == kNone) return uv;
  for (int k = 0; k < 3; ++k) uv += place.weight[k] * grid_->map.uv[3 * place.triangle + k];
  return uv;
}

Vector Texture::Centre(int i, int j) const {
  return frame.min() + Vector((i + 0.5) / width, (j + 0.5) / height).cwiseProduct(frame.sizes());
}

Eigen::VectorXd Texture::Sample(const Vector& uv) const {
  const Vector share = (uv - frame.min()).cwiseQuotient(frame.sizes());
  const auto [i, x] = Between(share.x(), width);
  const auto [j, y] = Between(share.y(), height);
  const auto at = [&](int column, int row) {
    return Eigen::VectorXd::Map(At(std::min(column, width - 1), std::min(row, height - 1)),
                                channels);
  };
  return (1 - y) * ((1 - x) * at(i, j) + x * at(i + 1, j)) +
         y * ((1 - x) * at(i, j + 1) + x * at(i + 1, j + 1));
}

void BakeTexture(const MapLocator& map, const SurfaceColour& colour, int margin, Texture* texture) {
  const std::size_t texels = static_cast<std::size_t>(texture->width) * texture->height;
  texture->value.assign(texels * texture->channels, 0);
  std::vector<char> has(texels, 0);
  ParallelFor(texture->height, [&](Index j) {
    for (int i = 0; i < texture->width; ++i) {
      const std::optional<SurfacePoint> point = map.PointAt(texture->Centre(i, j));
      if (!point) continue;
      Eigen::VectorXd::Map(texture->At(i, j), texture->channels) = colour(*point);
      has[static_cast<std::size_t>(j) * texture->width + i] = 1;
    }
  });
  for (int ring = 0; ring < margin; ++ring) Dilate(&has, texture);
}

void TransferTexture(const MapLocator& from, const Texture& texture, const MapLocator& to,
                     int margin, Texture* moved) {
  moved->channels = texture.channels;
  BakeTexture(
      to, [&](const SurfacePoint& point) { return texture.Sample(from.UvAt(point)); }, margin,
      moved);
}

Eigen::MatrixXd ValuesAt(const Triangulation& t, const Eigen::MatrixXd& of_vertices,
                         const std::vector<SurfacePoint>& points) {
  Eigen::MatrixXd values =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(points.size()), of_vertices.cols());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      values.row(static_cast<Eigen::Index>(i)) +=
          points[i].barycentric[k] * of_vertices.row(t.vertex[3 * points[i].face + k]);
    }
  }
  return values;
}

}  // namespace cirque

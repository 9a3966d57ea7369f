// Points, values and textures from one map of a surface to another: exact where they should be, and
// of second order where a texture is sampled.
#include "cirque/domains/transfer.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "cirque/domains/domain.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// A bumpy disk of long triangles with its plain map, its exact map and one to the unit disk.
class TransferTest : public testing::Test {
 protected:
  TransferTest() {
    MapRequest exact;
    exact.options.exact = true;
    plain_ = *MapSurface(surface_, exact);
    MapRequest disk;
    disk.domain = "disk";
    disk_ = *MapSurface(surface_, disk);
  }

  const Triangulation& t() const { return surface_.triangulation; }
  MapLocator Plain() const { return MapLocator(TrianglesOf(t(), plain_.uv)); }
  MapLocator Exact() const { return MapLocator(TrianglesOf(t(), *plain_.exact_map)); }
  MapLocator Disk() const { return MapLocator(TrianglesOf(t(), disk_.uv)); }

  Eigen::Vector3d Place(const SurfacePoint& point) const {
    Eigen::Vector3d sum(0, 0, 0);
    for (int k = 0; k < 3; ++k) {
      sum += point.barycentric[k] * surface_.position[t().vertex[3 * point.face + k]];
    }
    return sum;
  }

  static Texture Blank(const MapLocator& map, int size, int channels = 1) {
    Texture texture;
    texture.width = texture.height = size;
    texture.channels = channels;
    texture.frame = map.box();
    return texture;
  }

  const Surface surface_ =
      Moved(GeneratedSurface("bumpy_terrain", 500),
            [](const Eigen::Vector3d& x) { return Eigen::Vector3d(x.x(), x.y(), 3 * x.z()); });
  SurfaceMap plain_, disk_;
};

TEST_F(TransferTest, PointsComeBack) {
  ASSERT_GT(plain_.certificate.triangulation->flips, 20);
  const MapLocator plain = Plain(), exact = Exact(), disk = Disk();
  for (const MapLocator* map : {&plain, &exact, &disk}) {
    for (Index f = 0; f < t().num_faces(); ++f) {
      const SurfacePoint point{f, Eigen::Vector3d(0.2, 0.3, 0.5)};
      const auto back = map->PointAt(map->UvAt(point));
      ASSERT_TRUE(back);
      EXPECT_LT((Place(*back) - Place(point)).norm(), 1e-10);
    }
  }
  EXPECT_FALSE(disk.PointAt({1.1, 0}));
  EXPECT_FALSE(plain.PointAt(plain.box().max() + Eigen::Vector2d(1, 1)));
}

TEST_F(TransferTest, CornersOfAnExactMapAreWhereItHasThem) {
  const MapLocator exact = Exact();
  const ExactMap& map = *plain_.exact_map;
  for (std::size_t c = 0; c < map.corner.size(); ++c) {
    EXPECT_LT((exact.UvAt(map.point[map.corner[c]]) - map.uv[map.corner_uv[c]]).norm(), 1e-10);
  }
}

TEST_F(TransferTest, ATextureLinearInThePlaneMovesWithoutError) {
  const MapLocator exact = Exact(), disk = Disk();
  Texture linear = Blank(exact, 32, 2);
  linear.value.resize(32 * 32 * 2);
  for (int j = 0; j < 32; ++j) {
    for (int i = 0; i < 32; ++i) Eigen::Vector2d::Map(linear.At(i, j)) = linear.Centre(i, j);
  }
  Texture moved = Blank(disk, 100);
  TransferTexture(exact, linear, disk, 0, &moved);
  ASSERT_EQ(moved.channels, 2);
  int texels = 0;
  for (int j = 0; j < 100; ++j) {
    for (int i = 0; i < 100; ++i) {
      const auto point = disk.PointAt(moved.Centre(i, j));
      if (!point) continue;
      // Beyond the outermost texels' centres a texture is constant.
      const Eigen::Vector2d uv = exact.UvAt(*point), half = linear.frame.sizes() / 64;
      if (!((uv - linear.frame.min() - half).minCoeff() > 0) ||
          !((linear.frame.max() - half - uv).minCoeff() > 0)) {
        continue;
      }
      EXPECT_LT((Eigen::Vector2d::Map(moved.At(i, j)) - uv).norm(), 1e-12);
      ++texels;
    }
  }
  EXPECT_GT(texels, 6000);
}

TEST_F(TransferTest, ABakedTextureMovesWithErrorsOfSecondOrder) {
  const MapLocator exact = Exact(), disk = Disk();
  const SurfaceColour wave = [&](const SurfacePoint& point) {
    const Eigen::Vector3d x = Place(point);
    return Eigen::VectorXd::Constant(1, std::sin(3 * x.x()) + std::cos(2 * x.y()));
  };
  double before = 0;
  for (const int size : {64, 128, 256}) {
    Texture baked = Blank(exact, size), moved = Blank(disk, 100), direct = Blank(disk, 100);
    BakeTexture(exact, wave, 3, &baked);
    TransferTexture(exact, baked, disk, 0, &moved);
    BakeTexture(disk, wave, 0, &direct);
    double mean = 0;
    for (std::size_t i = 0; i < moved.value.size(); ++i) {
      mean += std::abs(moved.value[i] - direct.value[i]) / 7854;
    }
    if (before > 0) {
      EXPECT_LT(mean, 0.45 * before);
    }
    before = mean;
  }
  EXPECT_LT(before, 1e-3);
}

TEST_F(TransferTest, MarginsContinueWhatIsBeside) {
  const MapLocator disk = Disk();
  Texture texture = Blank(disk, 50);
  BakeTexture(
      disk, [](const SurfacePoint&) { return Eigen::VectorXd::Constant(1, 7); }, 2, &texture);
  EXPECT_EQ(*texture.At(25, 25), 7);
  EXPECT_EQ(*texture.At(0, 0), 0);  // the corner of the square is far from the disk
  const auto sevens = std::count(texture.value.begin(), texture.value.end(), 7.0);
  EXPECT_GT(sevens, 2100);  // pi / 4 of 2500 are 1963
  EXPECT_LT(sevens, 2400);
}

TEST_F(TransferTest, ValuesOfVerticesAreLinearOnFaces) {
  Eigen::MatrixXd place(t().num_vertices, 3);
  for (Index v = 0; v < t().num_vertices; ++v) place.row(v) = surface_.position[v];
  const std::vector<SurfacePoint>& points = plain_.exact_map->point;
  const Eigen::MatrixXd there = ValuesAt(t(), place, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT((there.row(static_cast<Eigen::Index>(i)).transpose() - Place(points[i])).norm(),
              1e-14);
  }
}

}  // namespace
}  // namespace cirque

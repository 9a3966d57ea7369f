#include "cirque/math/box_tree.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace cirque {
namespace {

/// In the plane and in space.
template <class Dimension>
class BoxTreeTest : public testing::Test {
 protected:
  static constexpr int kN = Dimension::value;
  using Point = Eigen::Matrix<double, kN, 1>;
  using Box = Eigen::AlignedBox<double, kN>;

  Point RandomPoint() {
    Point p;
    for (double& x : p) x = coordinate_(random_);
    return p;
  }

  std::vector<Box> RandomBoxes(int count) {
    std::uniform_real_distribution<double> exponent(-6, 0);
    std::vector<Box> boxes;
    for (int i = 0; i < count; ++i) {
      const Point corner = RandomPoint();
      const double size = std::pow(10, exponent(random_));
      boxes.emplace_back(corner, Point(corner + size * RandomPoint()));
    }
    return boxes;
  }

  std::mt19937 random_{4};
  std::uniform_real_distribution<double> coordinate_{0, 1};
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(BoxTreeTest, Dimensions);

TYPED_TEST(BoxTreeTest, FindsWhatATrialOfAllFinds) {
  for (const int count : {0, 1, 7, 8, 9, 500}) {
    const auto boxes = this->RandomBoxes(count);
    const BoxTreeOf<TestFixture::kN> tree(boxes);
    std::size_t found_in_all = 0;
    for (int query = 0; query < 40; ++query) {
      const auto corner = this->RandomPoint();
      const typename TestFixture::Box box(corner,
                                          typename TestFixture::Point(corner.array() + 0.1));
      std::vector<Index> found, expected;
      tree.VisitMeeting(box, [&](Index i) { found.push_back(i); });
      for (Index i = 0; i < count; ++i) {
        if (boxes[i].intersects(box)) expected.push_back(i);
      }
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected);
      found_in_all += found.size();
    }
    if (count > 100) {
      EXPECT_GT(found_in_all, 20u);
    }
  }
}

TYPED_TEST(BoxTreeTest, IsOverWhereNothingMeetsAnyMore) {
  const BoxTreeOf<TestFixture::kN> tree(this->RandomBoxes(500));
  int visited = 0;
  tree.VisitWhere([&](const auto&) { return visited < 3; }, [&](Index) { ++visited; });
  EXPECT_EQ(visited, 3);
}

}  // namespace
}  // namespace cirque

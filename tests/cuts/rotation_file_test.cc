#include "cirque/cuts/rotation_file.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

/// Hub 0 and rim 1 .. 6; face i (in the file: i + 1) has corners 0, i + 1, i + 2.
class RotationFile : public ::testing::Test {
 protected:
  StatusOr<std::vector<LoopRotation>> Parse(std::string_view text) const {
    return ParseRotations("r.txt", text, fan_.triangulation, NumbersInFile(fan_));
  }
  std::string Refusal(std::string_view text) const { return Parse(text).status().message(); }

  const Surface fan_ = Fan(6, 0.5);
};

TEST_F(RotationFile, ReadsLoopsOfFacesThatFollowEachOther) {
  const auto loops =
      Parse("# the hub, both ways round\n1.5 1 2 3 4 5 6\n\n-2e-1 6 5 4 3 2 1 # back\n");
  ASSERT_TRUE(loops.ok()) << loops.status().message();
  ASSERT_EQ(loops->size(), 2u);
  EXPECT_EQ((*loops)[0].rotation, 1.5);
  EXPECT_EQ((*loops)[1].rotation, -0.2);
  const Triangulation& t = fan_.triangulation;
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(t.num_halfedges());
  for (Index c = 0; c < t.num_halfedges(); ++c) {
    if (t.vertex[c] == 0) angles[c] = 1;
  }
  for (const double sign : {1., -1.}) {
    const LoopRotation& loop = (*loops)[sign > 0 ? 0 : 1];
    EXPECT_TRUE(loop.path.IsClosed());
    // Counter-clockwise around the hub: on the left.
    EXPECT_EQ(RotationAlong(CornersAlong(t, loop.path), angles), sign * 6);
  }
  EXPECT_TRUE(Parse("# nothing\n")->empty());
}

TEST_F(RotationFile, ErrorsNameTheLine) {
  EXPECT_THAT(Refusal("1 1 2 3 4 5 6\nx 1 2 3\n"),
              HasSubstr("r.txt:2: expected a rotation in radians"));
  EXPECT_THAT(Refusal("nan 1 2 3 4 5 6\n"), HasSubstr("r.txt:1: expected a rotation in radians"));
  EXPECT_THAT(Refusal("1 1 2 x\n"), HasSubstr("r.txt:1: expected a face (counted from 1)"));
  EXPECT_EQ(Refusal("\n1 1 2 7\n"), "r.txt:2: the surface has no face 7");
  EXPECT_EQ(Refusal("1 1 2 0\n"), "r.txt:1: the surface has no face 0");
  EXPECT_EQ(Refusal("1 1 2\n"), "r.txt:1: a loop passes at least three faces; here are 2");
  EXPECT_THAT(Refusal("1 1 2 4 5 6\n"), HasSubstr("r.txt:1: faces 2 and 4 have no edge in common"));
  EXPECT_THAT(Refusal("1 1 2 3\n"), HasSubstr("faces 3 and 1 have no edge in common"));
  EXPECT_EQ(Refusal("1 1 2 3 2\n"), "r.txt:1: the loop turns back in face 1");
}

TEST_F(RotationFile, LoopsAreOfTriangles) {
  PolygonSoup cube;
  for (int v = 0; v < 8; ++v) cube.position.emplace_back(v & 1, v >> 1 & 1, v >> 2);
  for (const auto& face :
       {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
        std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
    cube.corner.insert(cube.corner.end(), face.begin(), face.end());
    cube.first_corner.push_back(cube.first_corner.back() + 4);
  }
  const Surface surface = SurfaceOf(cube);
  EXPECT_THAT(ParseRotations("r.txt", "1 1 3 2 4\n", surface.triangulation, NumbersInFile(surface))
                  .status()
                  .message(),
              HasSubstr("r.txt:1: face 1 has more than three corners"));
}

}  // namespace
}  // namespace cirque

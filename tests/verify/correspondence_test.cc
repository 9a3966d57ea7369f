#include "cirque/verify/correspondence.h"

#include <algorithm>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/verify/fixtures.h"

namespace cirque::verify {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Face = std::vector<Index>;

/// Faces whose corners are named by these numbers.
NamedFaces Faces(const std::vector<Face>& faces) {
  NamedFaces named;
  for (const Face& face : faces) {
    named.name.insert(named.name.end(), face.begin(), face.end());
    named.first_corner.push_back(static_cast<Index>(named.name.size()));
  }
  return named;
}

std::vector<Face> TrianglesOf(const PolygonSoup& soup) {
  std::vector<Face> faces;
  for (std::size_t c = 0; c < soup.corner.size(); c += 3) {
    faces.push_back({soup.corner[c], soup.corner[c + 1], soup.corner[c + 2]});
  }
  return faces;
}

TEST(MatchFaces, FindsEveryFaceInWhateverOrder) {
  const std::vector<Face> in = TrianglesOf(Sheet(4));
  EXPECT_TRUE(MatchFaces(Faces(in), Faces(in)).same_order);
  std::vector<Index> order(in.size());
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 random(5);
  std::shuffle(order.begin(), order.end(), random);
  std::vector<Face> out;
  for (const Index f : order) {
    out.push_back(in[f]);
    std::rotate(out.back().begin(), out.back().begin() + f % 3, out.back().end());
  }
  const Correspondence match = MatchFaces(Faces(in), Faces(out));
  EXPECT_TRUE(match.complete());
  EXPECT_FALSE(match.same_order);
  EXPECT_THAT(match.reversed, IsEmpty());
  for (std::size_t i = 0; i < out.size(); ++i) {
    EXPECT_EQ(match.out_face[order[i]], static_cast<Index>(i));
  }
}

TEST(MatchFaces, WhatIsMissingExtraAndReversedIsNamed) {
  const std::vector<Face> in = TrianglesOf(Sheet(2));
  std::vector<Face> out = in;
  std::swap(out[5][0], out[5][1]);
  EXPECT_THAT(MatchFaces(Faces(in), Faces(out)).reversed, ElementsAre(5));
  EXPECT_TRUE(MatchFaces(Faces(in), Faces(out)).complete());
  out[2] = {0, 1, 8};
  const Correspondence match = MatchFaces(Faces(in), Faces(out));
  EXPECT_THAT(match.missing, ElementsAre(2));
  EXPECT_THAT(match.extra, ElementsAre(2));
  EXPECT_FALSE(match.complete());
  EXPECT_EQ(match.out_face[2], kNone);
  out[2] = {in[2][0], in[2][1], kNone};  // a corner that is none of IN's
  EXPECT_THAT(MatchFaces(Faces(in), Faces(out)).missing, ElementsAre(2));
}

// Two copies of one triangle stand for one of IN: the second is too many.
TEST(MatchFaces, AFaceListedTwiceIsExtra) {
  const std::vector<Face> in = TrianglesOf(Sheet(2));
  std::vector<Face> out = in;
  out.push_back(in[0]);
  const Correspondence match = MatchFaces(Faces(in), Faces(out));
  EXPECT_THAT(match.missing, IsEmpty());
  EXPECT_EQ(match.extra.size(), 1u);
}

// A sheet of two sides: the triangles that run the same way belong together.
TEST(MatchFaces, TwoFacesOnTheSameCornersAreToldApartByTheirDirection) {
  const std::vector<Face> in = {{0, 1, 2}, {0, 2, 1}}, out = {{2, 1, 0}, {1, 2, 0}};
  const Correspondence match = MatchFaces(Faces(in), Faces(out));
  EXPECT_THAT(match.out_face, ElementsAre(1, 0));
  EXPECT_THAT(match.reversed, IsEmpty());
}

TEST(MatchFaces, PolygonsMayBeCutAnyWay) {
  const std::vector<Face> in = {{0, 1, 2, 3, 4, 5}, {1, 0, 6}};
  const std::vector<std::vector<Face>> cuts = {
      {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {1, 0, 6}},
      {{0, 2, 4}, {1, 0, 6}, {0, 1, 2}, {2, 3, 4}, {4, 5, 0}},
      {{6, 1, 0}, {0, 1, 2, 5}, {2, 3, 4, 5}}};
  for (const std::vector<Face>& out : cuts) {
    const Correspondence match = MatchFaces(Faces(in), Faces(out));
    EXPECT_TRUE(match.complete());
    EXPECT_EQ(match.pieces.at(0).size() + 1, out.size());
    EXPECT_THAT(match.reversed, IsEmpty());
  }
  EXPECT_TRUE(MatchFaces(Faces(in), Faces(cuts[0])).same_order);
  EXPECT_FALSE(MatchFaces(Faces(in), Faces(cuts[1])).same_order);
  std::vector<Face> reversed = cuts[1];
  for (Face& face : reversed) std::reverse(face.begin(), face.end());
  EXPECT_THAT(MatchFaces(Faces(in), Faces(reversed)).reversed, ElementsAre(0, 1));
}

// Files have polygons that name a corner twice in a row, the first again at the end among them.
TEST(MatchFaces, PiecesOfAPolygonKnowNothingOfCornersThatRepeatTheOneBefore) {
  const std::vector<Face> in = {{0, 1, 1, 2, 3, 4, 0}, {1, 0, 5}};
  const std::vector<Face> out = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {1, 0, 5}};
  const std::vector<Face> in_other_order = {out[3], out[2], out[0], out[1]};
  for (const std::vector<Face>& faces : {out, in_other_order}) {
    EXPECT_TRUE(MatchFaces(Faces(in), Faces(faces)).complete());
  }
  EXPECT_FALSE(MatchFaces(Faces(in), Faces({out[0], out[1], out[3]})).complete());
  EXPECT_TRUE(MatchFaces(Faces(in), Faces(in)).complete());
}

// 0 1 2 and 3 4 5 with a bridge between 0 and 3; two triangles that meet at 0; a spur at 0.
TEST(MatchFaces, LoopsThatHangTogetherHaveTrianglesEachForItself) {
  const std::vector<Face> in = {{0, 1, 2, 0, 3, 4, 5, 3}, {0, 1, 2, 0, 6, 7}, {0, 1, 2, 0, 6}};
  const std::vector<Face> pieces = {{0, 1, 2}, {3, 4, 5}, {0, 6, 7}};
  EXPECT_TRUE(MatchFaces(Faces({in[0]}), Faces({pieces[1], pieces[0]})).complete());
  EXPECT_TRUE(MatchFaces(Faces({in[1]}), Faces({pieces[0], pieces[2]})).complete());
  const Correspondence spur = MatchFaces(Faces({in[2]}), Faces({pieces[0]}));
  EXPECT_TRUE(spur.complete());
  EXPECT_EQ(spur.pieces.count(0), 1u);
  EXPECT_FALSE(MatchFaces(Faces({in[0]}), Faces({pieces[0]})).complete());
  EXPECT_FALSE(MatchFaces(Faces({in[1]}), Faces({pieces[0], pieces[1]})).complete());
  EXPECT_FALSE(MatchFaces(Faces({in[2]}), Faces({{0, 2, 1}, {0, 1, 6}})).complete());
}

TEST(MatchFaces, PiecesThatDoNotFillAPolygonAreNoneOfIt) {
  const std::vector<Face> in = {{0, 1, 2, 3, 4}};
  for (const std::vector<Face>& out : {std::vector<Face>{{0, 1, 2}, {0, 2, 3}},
                                       {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 3, 4}},
                                       {{0, 1, 2}, {0, 2, 3}, {0, 4, 3}},
                                       {{0, 1, 2}, {0, 2, 3}, {1, 3, 4}}}) {
    EXPECT_FALSE(MatchFaces(Faces(in), Faces(out)).complete());
  }
}

// Both quadrilaterals have a piece with the corners 0, 2 and 4, in opposite directions.
TEST(MatchFaces, PiecesOfNeighboursOnTheSameCornersAreToldApart) {
  const std::vector<Face> in = {{0, 1, 2, 4}, {0, 4, 2, 3}};
  std::vector<Face> out = {{0, 1, 2}, {0, 2, 4}, {0, 4, 2}, {0, 2, 3}};
  do {
    const Correspondence match = MatchFaces(Faces(in), Faces(out));
    ASSERT_TRUE(match.complete());
    for (const Index g : match.pieces.at(0)) {
      EXPECT_THAT(out[g], ::testing::AnyOf(ElementsAre(0, 1, 2), ElementsAre(0, 2, 4)));
    }
  } while (std::next_permutation(out.begin(), out.end()));
}

}  // namespace
}  // namespace cirque::verify

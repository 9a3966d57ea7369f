#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/io/mesh_formats.h"

namespace cirque {
namespace {

using ::testing::ElementsAre;

PolygonSoup Parsed(const std::string& text) {
  StatusOr<PolygonSoup> soup = ParseObj("m.obj", text);
  EXPECT_TRUE(soup.ok()) << soup.status().message();
  return soup.ok() ? *soup : PolygonSoup();
}

std::string Message(const std::string& text) { return ParseObj("m.obj", text).status().message(); }

const std::string kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(ObjReader, ReadsPositionsAndPolygonsInOrder) {
  const PolygonSoup soup = Parsed(kThree + "v 1 1 -2.5e-3\nf 1 2 3\nf 2 4 3 1\n");
  ASSERT_EQ(soup.position.size(), 4u);
  EXPECT_EQ(soup.position[3], Eigen::Vector3d(1, 1, -2.5e-3));
  EXPECT_THAT(soup.first_corner, ElementsAre(0, 3, 7));
  EXPECT_THAT(soup.corner, ElementsAre(0, 1, 2, 1, 3, 2, 0));
  EXPECT_TRUE(soup.texture.empty());
  EXPECT_TRUE(soup.corner_texture.empty());
}

TEST(ObjReader, IgnoresWeightsColoursNormalsAndOtherKeywords) {
  const PolygonSoup soup = Parsed(
      "mtllib a.mtl\no thing#1\ng\nv 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0\nvn 0 0 1\nvp 1 2\n"
      "usemtl red\ns off\nl 1 2\np 1\nf 1//1 2//1 3//1\n");
  EXPECT_EQ(soup.position[1], Eigen::Vector3d(1, 0, 0));
  EXPECT_THAT(soup.corner, ElementsAre(0, 1, 2));
}

TEST(ObjReader, ReadsTextureCoordinatesOfSomeCorners) {
  const PolygonSoup soup =
      Parsed(kThree + "vn 0 0 1\nvt 0.5 0.25\nvt 2 3 9\nvt 7\nf 1/1 2/2/1 3//1\nf 3/-1 2 1\n");
  ASSERT_EQ(soup.texture.size(), 3u);
  EXPECT_EQ(soup.texture[0], Eigen::Vector2d(0.5, 0.25));
  EXPECT_EQ(soup.texture[1], Eigen::Vector2d(2, 3));
  EXPECT_EQ(soup.texture[2], Eigen::Vector2d(7, 0));
  EXPECT_THAT(soup.corner_texture, ElementsAre(0, 1, kNone, 2, kNone, kNone));
}

TEST(ObjReader, NegativeIndicesCountBackFromTheLatest) {
  const PolygonSoup soup = Parsed(kThree + "f -3 -2 -1\nv 5 5 5\nf -1 -2 -3\n");
  EXPECT_THAT(soup.corner, ElementsAre(0, 1, 2, 3, 2, 1));
}

TEST(ObjReader, AFaceMayUseALaterVertex) {
  EXPECT_THAT(Parsed("f 1 2 3\n" + kThree).corner, ElementsAre(0, 1, 2));
}

TEST(ObjReader, TakesEveryKindOfLine) {
  const std::string kinds[] = {
      "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",                             // CRLF
      "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3",                                       // CR
      "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",                           // byte order mark
      "# head\n\n  v\t0 0 0 # first\nv 1 0 0#second\n v +0 1.0e0 -0\nf 1 2 3 #",  // comments,
                                                                                  // blanks
      "v 0 0 \\\n0\nv 1 \\\r\n 0 0\nv 0 1 0\nf 1\\\n 2 \\\n3\n",                  // continued
      "o a \\\nf 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/ 2// 3//\n",  // continued, ignored
  };
  for (const std::string& text : kinds) {
    SCOPED_TRACE(text);
    const PolygonSoup soup = Parsed(text);
    EXPECT_THAT(soup.position, ElementsAre(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0),
                                           Eigen::Vector3d(0, 1, 0)));
    EXPECT_THAT(soup.corner, ElementsAre(0, 1, 2));
  }
}

TEST(ObjReader, ReadsNumbersThatAreNotFiniteOrTooLargeAsSuch) {
  const PolygonSoup soup = Parsed("v nan inf -inf\nv 1e999 -1e999 1e-999\n");
  EXPECT_TRUE(std::isnan(soup.position[0].x()));
  EXPECT_EQ(soup.position[0].y(), INFINITY);
  EXPECT_EQ(soup.position[0].z(), -INFINITY);
  EXPECT_EQ(soup.position[1], Eigen::Vector3d(INFINITY, -INFINITY, 0));
}

TEST(ObjReader, PassesOverWithAWarningWhatAMapCanDoWithout) {
  PolygonSoup soup = Parsed(kThree + "f 1 2\nf 1 2 3\nf 3\nf\n");
  EXPECT_THAT(soup.corner, ElementsAre(0, 1, 2));
  EXPECT_THAT(soup.warnings,
              ElementsAre("m.obj:4: a face of fewer than 3 corners is ignored (and 2 times more)"));
  // Texture coordinates that are not there.
  soup = Parsed(kThree + "vt 0 0\nf 1/1 2/2 3/1\nf 1/7 2/1 3/1\nvt 1 1\n");
  EXPECT_THAT(soup.corner_texture, ElementsAre(0, 1, 0, kNone, 0, 0));
  EXPECT_THAT(soup.warnings, ElementsAre("m.obj:6: texture coordinate index 7, but the file has "
                                         "only 2; such corners have none"));
  soup = Parsed(kThree + "f 1/1/1 2/2/2 3/3/3\n");
  EXPECT_TRUE(soup.corner_texture.empty());
  EXPECT_EQ(soup.warnings.size(), 1u);
  // 0 for texture and normal that a corner does not have.
  soup = Parsed(kThree + "vt 5 5\nf 1/0/0 2/-2/0 3/1/0\n");
  EXPECT_THAT(soup.corner_texture, ElementsAre(kNone, kNone, 0));
  EXPECT_THAT(soup.warnings,
              ElementsAre("m.obj:5: there is no such texture coordinate (OBJ counts from 1): the "
                          "corner has none (and 1 time more)"));
  // A line without numbers leaves the others without meaning.
  soup = Parsed(kThree + "vt 1 1\nvt\nf 1/1 2/2 3/1\n");
  EXPECT_TRUE(soup.texture.empty());
  EXPECT_TRUE(soup.corner_texture.empty());
  EXPECT_THAT(soup.warnings, ElementsAre("m.obj:5: 'vt' without numbers: all texture coordinates "
                                         "of the file are ignored"));
}

TEST(ObjReader, NumbersThatAreNotFiniteAreTheirsInEverySpelling) {
  for (const std::string word :
       {"nan", "NaN", "-nan", "nan(ind)", "-nan(ind)", "NAN(snan)", "inf", "-INF", "Infinity",
        "+infinity", "1.#IND", "-1.#IND", "1.#QNAN", "1.#INF00", "-1.#J", "1e999"}) {
    const PolygonSoup soup = Parsed(kThree + "v 0 " + word + " 0\nf 1 2 3\n");
    ASSERT_EQ(soup.position.size(), 4u) << word;
    EXPECT_FALSE(std::isfinite(soup.position[3].y())) << word;
    EXPECT_EQ(soup.position[3].z(), 0) << word;
    EXPECT_EQ(soup.not_finite_at, "m.obj:4") << word;
  }
}

TEST(ObjReader, NamesLineAndRemedyOfMalformedInput) {
  EXPECT_EQ(Message("v 0 0\n"),
            "m.obj:1: expected three coordinates, 'v x y z', got the end of the line");
  EXPECT_EQ(Message("\nv 0 zero 0\n"),
            "m.obj:2: expected three coordinates, 'v x y z', got 'zero'");
  EXPECT_EQ(Message("v 0 0 1,5\n"), "m.obj:1: expected three coordinates, 'v x y z', got '1,5'");
  EXPECT_EQ(Message("vt 1 b\n"), "m.obj:1: expected texture coordinates, 'vt u v', got 'b'");
  EXPECT_EQ(Message(kThree + "f 0 1 2\n"),
            "m.obj:4: vertex index 0; OBJ counts from 1 (or back from -1)");
  EXPECT_EQ(Message(kThree + "f -4 -1 -2\n"),
            "m.obj:4: vertex index -4 goes back beyond the first of the 3 before it");
  EXPECT_EQ(Message(kThree + "f 1 2 3\nf 1 2 4\nf 3 2 1\n"),
            "m.obj:5: vertex index 4, but the file has only 3; correct the index or check that "
            "the file is complete");
  for (const std::string bad :
       {"x", "1/a", "1/2/3/4", "/1", "1.5", "99999999999999999999", "1//x"}) {
    EXPECT_EQ(Message(kThree + "f 1 2 " + bad + "\n"),
              "m.obj:4: expected a face corner v, v/vt, v//vn or v/vt/vn, got '" + bad + "'");
  }
  EXPECT_EQ(Message("v 0 \\\n 0 \\\n x\n"),
            "m.obj:3: expected three coordinates, 'v x y z', got 'x'");
  EXPECT_EQ(Message("v \x01\x80 0 0"), "m.obj:1: expected three coordinates, 'v x y z', got '?\?'");
}

}  // namespace
}  // namespace cirque

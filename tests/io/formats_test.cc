// The readers of OFF, PLY and STL on their variants, and their messages.

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/io/file_input.h"
#include "cirque/io/mesh_formats.h"

namespace cirque {
namespace {

using ::testing::ElementsAre;

using Parser = StatusOr<PolygonSoup> (*)(const std::string&, std::string_view);

/// The number's bytes in the given order.
template <class T>
std::string Bytes(T value, ByteOrder order = ByteOrder::kLittle) {
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
  if ((order == ByteOrder::kLittle) != (std::endian::native == std::endian::little)) {
    std::reverse(bytes.begin(), bytes.end());
  }
  return bytes;
}

std::string Message(Parser parse, const std::string& text) {
  return parse("m", text).status().message();
}

/// The points (0.1, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), as `Number` keeps them, a triangle and
/// a quadrilateral.
template <class Number>
void ExpectTwoFaces(Parser parse, const std::string& text) {
  const StatusOr<PolygonSoup> soup = parse("m", text);
  ASSERT_TRUE(soup.ok()) << soup.status().message();
  EXPECT_THAT(soup->position, ElementsAre(Eigen::Vector3d(static_cast<double>(Number(0.1)), 0, 0),
                                          Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0),
                                          Eigen::Vector3d(1, 1, 0)));
  EXPECT_THAT(soup->first_corner, ElementsAre(0, 3, 7));
  EXPECT_THAT(soup->corner, ElementsAre(0, 1, 2, 0, 1, 3, 2));
  EXPECT_TRUE(soup->corner_texture.empty());
}

TEST(OffReader, ReadsItsVariants) {
  const std::string body = "0.1 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n4 0 1 3 2\n";
  ExpectTwoFaces<double>(ParseOff, "OFF\n4 2 0\n" + body);
  ExpectTwoFaces<double>(ParseOff, "OFF 4 2\n" + body);
  ExpectTwoFaces<double>(
      ParseOff,
      "# made by hand\r\nSTCNOFF # all\r\n\r\n4 2 5\r\n0.1 0 0 0 0 1 255 0 0 0 0 "
      "\r\n1 0 0\r\n0 1 0\r\n1 1 0\r\n3 0 1 2 255 0 0\r\n4 0 1 3 2 0.5 1 1");
}

TEST(OffReader, NamesLineAndRemedyOfMalformedInput) {
  EXPECT_EQ(Message(ParseOff, "4OFF\n"),
            "m:1: expected the keyword OFF (or COFF, NOFF, STOFF); is this a text OFF file of "
            "points in space?");
  EXPECT_EQ(Message(ParseOff, "OFF BINARY\n"),
            "m:1: expected the numbers of vertices and faces, got 'BINARY'");
  EXPECT_EQ(Message(ParseOff, "OFF\n3 -1 0\n"),
            "m:2: expected the numbers of vertices and faces, got '-1'");
  EXPECT_EQ(Message(ParseOff, "OFF\n2 0 0\n0 0 0\n"),
            "m:4: the file ends after vertex 1 of 2; is it cut off?");
  EXPECT_EQ(Message(ParseOff, "OFF\n1 0 0\n0 0\n"),
            "m:3: expected three coordinates of a vertex, got the end of the line");
  EXPECT_EQ(Message(ParseOff, "OFF\n1 1 0\n0 0 0\n3 0 0\n"),
            "m:4: expected 3 vertex indices, as the line says, got the end of the line");
  EXPECT_EQ(Message(ParseOff, "OFF\n1 1 0\n0 0 0\n3 0 0 1\n"),
            "m:4: expected a vertex index from 0 to 0, got 1; correct the index");
  EXPECT_EQ(Message(ParseOff, "OFF\n1 1 0\n0 0 0\n2 0 0\n"),
            "m:4: a face needs at least 3 corners, this one has 2; complete or remove it");
  EXPECT_EQ(Message(ParseOff, "OFF\n1 0 0\n0 0 0\n3 0 0 0\n"),
            "m:4: more lines follow than the header promises (vertices: 1, faces: 0); correct the "
            "header");
}

/// Properties of every kind to be skipped, before and after those that count.
std::string PlyHeaderText(const std::string& encoding, const std::string& real) {
  return "ply\nformat " + encoding +
         " 1.0\ncomment made # by hand\nobj_info none\nelement camera 1\nproperty list uchar float "
         "view\nelement nothing 1000000000000\nelement vertex 4\nproperty uchar red\nproperty " +
         real + " x\nproperty " + real + " y\nproperty " + real +
         " z\nproperty short s\nelement face 2\nproperty list uint8 int32 vertex_index\nproperty "
         "list ushort double texcoord\nend_header\n";
}

template <class Real>
std::string PlyBinaryBody(ByteOrder order) {
  const auto bytes = [&](auto value) { return Bytes(value, order); };
  std::string body = bytes(std::uint8_t{2}) + bytes(7.0F) + bytes(8.0F);
  const double points[4][3] = {{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  for (const auto& point : points) {
    body += bytes(std::uint8_t{200});
    for (const double coordinate : point) body += bytes(static_cast<Real>(coordinate));
    body += bytes(std::int16_t{-3});
  }
  body += bytes(std::uint8_t{3});
  for (const int v : {0, 1, 2}) body += bytes(std::int32_t{v});
  body += bytes(std::uint16_t{1}) + bytes(0.5) + bytes(std::uint8_t{4});
  for (const int v : {0, 1, 3, 2}) body += bytes(std::int32_t{v});
  return body + bytes(std::uint16_t{0});
}

const std::string kPlyTextBody =
    "2 7 8\n200 0.1 0 0 -3\n200 1 0 0 -3\n200 0 1 0 -3\n200 1 1 0 -3\n3 0 1 2 1 0.5\n4 0 1 3 2 0\n";

TEST(PlyReader, ReadsTextAndBothByteOrders) {
  ExpectTwoFaces<double>(ParsePly, PlyHeaderText("ascii", "double") + kPlyTextBody);
  ExpectTwoFaces<double>(ParsePly, PlyHeaderText("ascii", "float") + kPlyTextBody);
  ExpectTwoFaces<double>(ParsePly, PlyHeaderText("binary_little_endian", "float64") +
                                       PlyBinaryBody<double>(ByteOrder::kLittle));
  ExpectTwoFaces<float>(ParsePly, PlyHeaderText("binary_big_endian", "float") +
                                      PlyBinaryBody<float>(ByteOrder::kBig));
}

/// Three points with two more numbers each under these names, and a triangle.
std::string PlyWithTexture(const std::string& u, const std::string& v, const std::string& list = "",
                           const std::string& values = "") {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float " + v +
         "\nproperty float y\nproperty float z\nproperty float " + u + "\nelement face 1\n" + list +
         "property list uchar int vertex_indices\nend_header\n"
         "0 8 0 0 2\n1 9 0 0 3\n0 10 1 0 4\n" +
         values + "3 2 1 0\n";
}

TEST(PlyReader, ReadsTextureCoordinatesOfVerticesUnderTheirUsualNames) {
  using Uv = Eigen::Vector2d;
  for (const auto& [u, v] :
       {std::pair("s", "t"), {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}) {
    const PolygonSoup soup = *ParsePly("m", PlyWithTexture(u, v));
    EXPECT_THAT(soup.texture, ElementsAre(Uv(2, 8), Uv(3, 9), Uv(4, 10)));
    EXPECT_THAT(soup.corner_texture, ElementsAre(2, 1, 0));
  }
  for (const auto& [u, v] : {std::pair("s", "v"), {"nx", "ny"}, {"s", "quality"}}) {
    const PolygonSoup soup = *ParsePly("m", PlyWithTexture(u, v));
    EXPECT_TRUE(soup.texture.empty());
    EXPECT_TRUE(soup.corner_texture.empty());
  }
}

TEST(PlyReader, TextureCoordinatesOfAFacesCornersComeBeforeThoseOfVertices) {
  using Uv = Eigen::Vector2d;
  const std::string list = "property list uchar float texcoord\n";
  const PolygonSoup soup = *ParsePly("m", PlyWithTexture("s", "t", list, "6 1 2 3 4 5 6 "));
  EXPECT_THAT(soup.texture, ElementsAre(Uv(1, 2), Uv(3, 4), Uv(5, 6)));
  EXPECT_THAT(soup.corner_texture, ElementsAre(0, 1, 2));
  // A list of another length holds something else.
  EXPECT_THAT(ParsePly("m", PlyWithTexture("s", "t", list, "5 1 2 3 4 5 "))->texture,
              ElementsAre(Uv(2, 8), Uv(3, 9), Uv(4, 10)));
  EXPECT_TRUE(ParsePly("m", PlyWithTexture("a", "b", list, "0 "))->texture.empty());
}

TEST(PlyReader, EveryTruncationIsAnError) {
  for (const std::string& whole :
       {PlyHeaderText("ascii", "double") + kPlyTextBody.substr(0, kPlyTextBody.size() - 1),
        PlyHeaderText("binary_big_endian", "float") + PlyBinaryBody<float>(ByteOrder::kBig)}) {
    for (std::size_t size = 0; size < whole.size(); ++size) {
      EXPECT_FALSE(ParsePly("m", whole.substr(0, size)).ok()) << size;
    }
  }
}

TEST(PlyReader, NamesPlaceAndRemedyOfMalformedInput) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  EXPECT_EQ(Message(ParsePly, "plx\n"),
            "m:1: expected 'ply' on the first line; is this a PLY file?");
  EXPECT_EQ(Message(ParsePly, "ply\nformat asci 1.0\n"),
            "m:2: unknown PLY format 'asci'; did you mean 'ascii'? Known: ascii, "
            "binary_little_endian, binary_big_endian");
  EXPECT_EQ(Message(ParsePly, "ply\nelement vertex x\n"),
            "m:2: expected 'element NAME COUNT', got 'x'");
  EXPECT_EQ(Message(ParsePly, "ply\nproperty float x\n"),
            "m:2: expected an element before its properties");
  EXPECT_EQ(Message(ParsePly, "ply\nend_header\n"), "m:2: expected a 'format' line in the header");
  EXPECT_EQ(Message(ParsePly, "ply\nvertex 3\n"),
            "m:2: expected format, element, property, comment or end_header, got 'vertex'");
  EXPECT_EQ(Message(ParsePly, "ply\nformat ascii 1.0\nelement vertex 0\nend_header\n"),
            "m:4: expected an element 'vertex' with x, y and z, then an element 'face' with a list "
            "vertex_indices; write the mesh as polygons (not strips or points)");
  EXPECT_EQ(Message(ParsePly, head + "0 a 0\n"),
            "m:10: expected a number for property 'y' of element 'vertex', got 'a'");
  EXPECT_EQ(Message(ParsePly, head + "0 0 0\n"),
            "m:11: the file ends after 0 of 1 elements 'face'; is it cut off?");
  EXPECT_EQ(Message(ParsePly, head + "0 0 0\n-1 0\n"),
            "m:11: a list of length -1; the file is damaged");
  EXPECT_EQ(Message(ParsePly, head + "0 0 0\n3 0 0 0.5\n"), "m:11: vertex index 0.5");
  EXPECT_EQ(Message(ParsePly, head + "0 0 0\n3 0 0 1\n"),
            "m:11: expected a vertex index from 0 to 0, got 1; correct the index");
  EXPECT_EQ(Message(ParsePly, head + "0 0 0\n3 0 0 0\n9\n"),
            "m:12: more lines follow than the header promises; correct the header");
}

const std::string kStlText =
    "solid a\nfacet normal 0 0 1\n outer loop\n  vertex 0.1 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n "
    "endloop\nendfacet\nendsolid a\nsolid b\nfacet normal 0 0 1\nouter loop\nvertex 1 0 -0\nvertex "
    "1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid b\n";

std::string StlBinary() {
  std::string bytes(80, 's');
  bytes.replace(0, 5, "solid");  // as some programs write it, to mislead readers
  bytes += Bytes(std::uint32_t{2});
  const float triangles[2][12] = {{0, 0, 1, 0.1F, 0, 0, 1, 0, 0, 0, 1, 0},
                                  {0, 0, 1, 1, 0, -0.0F, 1, 1, 0, 0, 1, 0}};
  for (const auto& triangle : triangles) {
    for (const float number : triangle) bytes += Bytes(number);
    bytes += "ab";
  }
  return bytes;
}

TEST(StlReader, WeldsEqualVerticesOfTextAndBinary) {
  const double tenth[] = {0.1, static_cast<double>(0.1F)};
  const std::string texts[] = {kStlText, StlBinary()};
  for (int i = 0; i < 2; ++i) {
    const StatusOr<PolygonSoup> soup = ParseStl("m", texts[i]);
    ASSERT_TRUE(soup.ok()) << soup.status().message();
    EXPECT_THAT(soup->position,
                ElementsAre(Eigen::Vector3d(tenth[i], 0, 0), Eigen::Vector3d(1, 0, 0),
                            Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1, 1, 0)));
    EXPECT_THAT(soup->first_corner, ElementsAre(0, 3, 6));
    EXPECT_THAT(soup->corner, ElementsAre(0, 1, 2, 1, 3, 2));
  }
}

TEST(StlReader, NamesPlaceAndRemedyOfMalformedInput) {
  EXPECT_EQ(Message(ParseStl, "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 x 0\n"),
            "m:4: expected three coordinates, 'vertex x y z', got 'x'");
  EXPECT_EQ(Message(ParseStl, "solid\nfacet\nouter loop\nvertex 0 0 0\nendloop\n"),
            "m:5: expected 'vertex', got 'endloop'");
  EXPECT_EQ(Message(ParseStl, "solid\nfacte\n"),
            "m:2: expected 'facet' or 'endsolid', got 'facte'");
  EXPECT_EQ(Message(ParseStl, "solid\n"), "m:2: the file ends before 'endsolid'; is it cut off?");
  EXPECT_EQ(Message(ParseStl, "what"),
            "m: neither text STL (it does not start with 'solid') nor binary (it is shorter than "
            "84 bytes); is it cut off?");
  std::string cut = StlBinary();
  cut[0] = 'S';
  cut.pop_back();
  EXPECT_EQ(Message(ParseStl, cut),
            "m: a binary STL file with the count in its header has 184 bytes, this one has 183; is "
            "it cut off, or not STL?");
}

}  // namespace
}  // namespace cirque

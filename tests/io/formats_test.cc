// The readers of OFF, PLY, STL and OM on their variants, and their messages.

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/core/count.h"
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
            "m:1: 4OFF and nOFF hold points of other than three coordinates; project them to "
            "space");
  EXPECT_EQ(Message(ParseOff, "STnOFF\n"), Message(ParseOff, "4OFF\n"));
  EXPECT_EQ(Message(ParseOff, ""), "m:1: the file is empty");
  EXPECT_EQ(Message(ParseOff, "FOFF\n3 1 0\n"),
            "m:1: expected the keyword OFF (or COFF, NOFF, STOFF); is this an OFF file?");
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
  EXPECT_EQ(Message(ParseOff, "OFF\n1 1 0\n0 0 0\n-3 0 0\n"),
            "m:4: a face of -3 corners; the file is damaged");
}

TEST(OffReader, PassesOverWithAWarningWhatAMapCanDoWithout) {
  const std::string points = "0.1 0 0\n1 0 0\n0 1 0\n1 1 0\n";
  const std::string body = points + "3 0 1 2\n4 0 1 3 2\n";
  const auto warnings = [](const std::string& text) {
    ExpectTwoFaces<double>(ParseOff, text);
    return ParseOff("m", text)->warnings;
  };
  EXPECT_THAT(warnings("OFF4 2 0\n" + body), ElementsAre());  // of ModelNet: a blank forgotten
  EXPECT_THAT(warnings("4 2 0\n" + body), ElementsAre("m:1: the keyword OFF is missing"));
  EXPECT_THAT(warnings("OFF 4 2 0\n" + body + "0\n"),
              ElementsAre("m:8: more follows than the header promises, and is ignored"));
  EXPECT_THAT(warnings("OFF 4 4 0\n" + points + "2 0 1\n3 0 1 2\n1 3\n4 0 1 3 2\n"),
              ElementsAre("m:6: a face of fewer than 3 corners is ignored (and 1 time more)"));
}

TEST(OffReader, ReadsTextureCoordinatesOfVertices) {
  using Uv = Eigen::Vector2d;
  const std::string faces = "3 0 1 2 255 0 0\n";
  PolygonSoup soup =
      *ParseOff("m", "STCOFF 3 1\n0 0 0 255 0 0 1 2\n1 0 0 9 9 9 9 3 4\n0 1 0 5 6\n" + faces);
  EXPECT_THAT(soup.texture, ElementsAre(Uv(1, 2), Uv(3, 4), Uv(5, 6)));
  EXPECT_THAT(soup.corner_texture, ElementsAre(0, 1, 2));
  soup = *ParseOff("m", "STOFF 3 1\n0 0 0 1 2\n1 0 0 3\n0 1 0 5 6\n" + faces);
  EXPECT_TRUE(soup.texture.empty());
  EXPECT_THAT(soup.warnings, ElementsAre("m:3: a vertex without the texture coordinates that the "
                                         "keyword promises: all of them are ignored"));
}

/// The two faces, the first of them with a colour of three numbers.
std::string OffBinary(const std::string& keyword, int reals_behind) {
  const auto whole = [](int n) { return Bytes(std::int32_t{n}, ByteOrder::kBig); };
  const auto real = [](float x) { return Bytes(x, ByteOrder::kBig); };
  std::string bytes = keyword + " BINARY\n" + whole(4) + whole(3) + whole(0);
  const float points[4][2] = {{0.1F, 0}, {1, 0}, {0, 1}, {1, 1}};
  for (const auto& [x, y] : points) {
    bytes += real(x) + real(y) + real(0);
    for (int i = 0; i < reals_behind; ++i) bytes += real(static_cast<float>(i));
  }
  bytes += whole(3) + whole(0) + whole(1) + whole(2) + whole(3) + real(1) + real(0) + real(0);
  bytes += whole(2) + whole(0) + whole(1) + whole(0);
  return bytes + whole(4) + whole(0) + whole(1) + whole(3) + whole(2) + whole(0);
}

TEST(OffReader, ReadsBinary) {
  ExpectTwoFaces<float>(ParseOff, OffBinary("OFF", 0));
  ExpectTwoFaces<float>(ParseOff, OffBinary("CNOFF", 7));
  EXPECT_THAT(ParseOff("m", OffBinary("STOFF", 2))->texture.back(), Eigen::Vector2d(0, 1));
  EXPECT_THAT(ParseOff("m", OffBinary("OFF", 0) + "x")->warnings,
              ElementsAre("m: byte 108 after the header: a face of fewer than 3 corners is ignored",
                          "m: byte 132 after the header: more follows than the header promises, "
                          "and is ignored"));
  const std::string whole = OffBinary("OFF", 0);
  for (std::size_t size = 0; size + 4 < whole.size(); ++size) {  // the last: no colour
    EXPECT_FALSE(ParseOff("m", whole.substr(0, size)).ok()) << size;
  }
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
  EXPECT_EQ(Message(ParsePly, "ply\nformat ascii 1.0\nelement vertex 0\nend_header\n"),
            "m:4: expected an element 'vertex' with x, y and z, then an element 'face' (or "
            "'tristrips') with a list vertex_indices; are these points without faces?");
  EXPECT_EQ(Message(ParsePly, head + "0 a 0\n"),
            "m:10: expected a number for property 'y' of element 'vertex', got 'a'");
  EXPECT_EQ(Message(ParsePly, head + "0 0 0\n"),
            "m:11: the file ends after 0 of 1 elements 'face'; is it cut off?");
  EXPECT_EQ(Message(ParsePly, head + "0 0 0\n-1 0\n"),
            "m:11: a list of length -1; the file is damaged");
  EXPECT_EQ(Message(ParsePly, head + "0 0 0\n3 0 0 0.5\n"), "m:11: vertex index 0.5");
  EXPECT_EQ(Message(ParsePly, head + "0 0 0\n3 0 0 1\n"),
            "m:11: expected a vertex index from 0 to 0, got 1; correct the index");
}

TEST(PlyReader, PassesOverWithAWarningWhatAMapCanDoWithout) {
  const std::string head =
      "ply\nformat ascii 1.0\nCreated by X # there\nobj_info x\nelement vertex 3\nproperty float "
      "x\nproperty float y\nproperty float z\nelement face 2\nproperty list uchar int "
      "vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
  const PolygonSoup soup = *ParsePly("m", head + "2 0 1\n3 0 1 2\nmore\n");
  EXPECT_THAT(soup.corner, ElementsAre(0, 1, 2));
  EXPECT_THAT(soup.warnings,
              ElementsAre("m:3: a line of the header that begins with 'Created' is ignored",
                          "m:15: a face of fewer than 3 corners is ignored",
                          "m:17: more lines follow than the header promises, and are ignored"));
}

TEST(PlyReader, ReadsStripsOfTriangles) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty "
      "float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n";
  // Every second triangle is turned around; -1 begins anew.
  EXPECT_THAT(ParsePly("m", head + "9 0 1 2 3 4 -1 4 3 5\n")->corner,
              ElementsAre(0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5));
  // Triangles that only carry the strip on.
  EXPECT_THAT(ParsePly("m", head + "6 0 1 2 2 3 4\n")->corner, ElementsAre(0, 1, 2, 3, 2, 4));
  EXPECT_EQ(Message(ParsePly, head + "3 0 1 6\n"),
            "m:16: expected a vertex index from 0 to 5, got 6; correct the index");
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

TEST(StlReader, ReadsEverySpelling) {
  const PolygonSoup soup = *ParseStl("m", kStlText);
  std::string capitals = kStlText;
  for (char& c : capitals) c = static_cast<char>(std::toupper(c));
  std::string apart = kStlText;
  for (const std::string word : {"endsolid", "endfacet", "endloop"}) {
    for (std::size_t at; (at = apart.find(word)) != std::string::npos;) apart.insert(at + 3, " ");
  }
  std::string joined = kStlText;  // fewer lines
  for (std::size_t at; (at = joined.find("\nouter")) != std::string::npos;) joined[at] = ' ';
  std::string returns = kStlText;
  std::replace(returns.begin(), returns.end(), '\n', '\r');
  for (const std::string& text : {capitals, apart, joined, returns, "\n  " + kStlText}) {
    const StatusOr<PolygonSoup> read = ParseStl("m", text);
    ASSERT_TRUE(read.ok()) << read.status().message() << text;
    EXPECT_EQ(read->position, soup.position);
    EXPECT_EQ(read->corner, soup.corner);
  }
}

TEST(StlReader, WhatStandsBehindTheTrianglesIsIgnoredWhereItIsNone) {
  for (const std::string& tail :
       {std::string(1, '\0'), std::string(49, 'x'), std::string(500, '\0')}) {
    const PolygonSoup soup = *ParseStl("m", StlBinary() + tail);
    EXPECT_THAT(soup.corner, ElementsAre(0, 1, 2, 1, 3, 2));
    EXPECT_THAT(soup.warnings, ElementsAre("m: what is behind the announced triangles, " +
                                           Count(tail.size(), "byte") + ", is ignored"));
  }
  EXPECT_EQ(Message(ParseStl, StlBinary() + std::string(50, 'x')),
            "m: a binary STL file with the count in its header has 184 bytes, this one has 234; is "
            "it cut off, or not STL?");
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

/// A triangle and a quadrilateral as OM of version 1.2: positions of doubles, then faces by vertices.
std::string OldOm() {
  std::string bytes = "OMP\x22" + Bytes<std::uint32_t>(4) + Bytes<std::uint32_t>(2) +
                      Bytes<std::uint32_t>(5) + Bytes<std::uint16_t>(0x5600);
  for (const double x : {0.1, 0., 0., 1., 0., 0., 0., 1., 0., 1., 1., 0.}) bytes += Bytes(x);
  bytes += Bytes<std::uint16_t>(0x42e8);  // of faces, topology, 16 bits
  const std::vector<std::vector<std::uint16_t>> faces = {{0, 1, 2}, {0, 1, 3, 2}};
  for (const auto& face : faces) {
    bytes += Bytes(static_cast<std::uint16_t>(face.size()));
    for (const std::uint16_t v : face) bytes += Bytes(v);
  }
  return bytes + Bytes<std::uint16_t>(0x1c);
}

/// What OpenMesh 9 writes of the triangles 0 1 2 and 2 1 3 (halfedges by next, vertex, face), a
/// property before them.
std::string Om() {
  std::string bytes = "OMTB" + Bytes<std::uint32_t>(4) + Bytes<std::uint32_t>(2) +
                      Bytes<std::uint32_t>(5) + Bytes<std::uint16_t>(0x1600);
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 1.F, 1.F, 0.F})
    bytes += Bytes(x);
  bytes += Bytes<std::uint16_t>(0x00c2) + "\1a\3int" + Bytes<std::uint32_t>(3) + "xyz";
  bytes += Bytes<std::uint16_t>(0x16f8);
  for (const int n : {2, 1, 0,  5, 0, -1, 4, 2, 0,  6, 1, 1, 0, 0, 0,
                      9, 2, -1, 8, 3, 1,  1, 1, -1, 3, 2, 1, 7, 3, -1}) {
    bytes += static_cast<char>(n);
  }
  bytes += Bytes<std::uint16_t>(0x06e8) + std::string("\0\3", 2);
  return bytes + Bytes<std::uint16_t>(0x1c);
}

TEST(OmReader, ReadsBothVersionsAndPassesOverProperties) {
  const StatusOr<PolygonSoup> old = ParseOm("m", OldOm()), now = ParseOm("m", Om());
  ASSERT_TRUE(old.ok()) << old.status().message();
  EXPECT_EQ(old->position[0], Eigen::Vector3d(0.1, 0, 0));
  EXPECT_THAT(old->first_corner, ElementsAre(0, 3, 7));
  EXPECT_THAT(old->corner, ElementsAre(0, 1, 2, 0, 1, 3, 2));
  ASSERT_TRUE(now.ok()) << now.status().message();
  EXPECT_EQ(now->position[3], Eigen::Vector3d(1, 1, 0));
  EXPECT_THAT(now->corner, ElementsAre(1, 2, 0, 1, 3, 2));
  EXPECT_TRUE(old->warnings.empty() && now->warnings.empty());
}

// OpenMesh's own reader takes such files for whole ones.
TEST(OmReader, RefusesFilesThatAreCutOffAnywhere) {
  for (const std::string& whole : {OldOm(), Om()}) {
    for (std::size_t size = 0; size < whole.size() - 2; ++size) {
      EXPECT_FALSE(ParseOm("m", whole.substr(0, size)).ok()) << size;
    }
    EXPECT_EQ(ParseOm("m", whole.substr(0, whole.size() - 2))->warnings.size(), 1u);
  }
}

TEST(OmReader, RefusesConnectivityThatIsNone) {
  std::string twice = Om();
  twice[twice.size() - 3] = '\0';  // both faces of the same halfedges
  EXPECT_EQ(
      Message(ParseOm, twice),
      "m: byte 119: the halfedges of face 2 (counted from 1) do not close; the file is damaged");
  std::string far = OldOm();
  far[far.size() - 4] = '\4';
  EXPECT_EQ(Message(ParseOm, far),
            "m: byte 126: expected a vertex index from 0 to 3, got 4; correct the index");
  std::string many = Om();
  many[11] = '\x7f';  // two thousand million faces
  EXPECT_FALSE(ParseOm("m", many).ok());
}

}  // namespace
}  // namespace cirque

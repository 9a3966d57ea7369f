// OBJ files with other texture coordinates.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/io/file_input.h"
#include "cirque/io/io.h"
#include "cirque/io/mesh_formats.h"

#include "tests/common/temporary_folder.h"
#include "tests/io/mutate.h"

namespace cirque {
namespace {

/// The file's own polygons, corner c with texture coordinate c, at (c, c + 1/2).
PolygonSoup WithOwnTexture(const std::string& text) {
  StatusOr<PolygonSoup> soup = ParseObj("m.obj", text);
  EXPECT_TRUE(soup.ok()) << soup.status().message();
  soup->texture.clear();
  soup->corner_texture.clear();
  for (std::size_t c = 0; c < soup->corner.size(); ++c) {
    soup->texture.emplace_back(c, static_cast<double>(c) + 0.5);
    soup->corner_texture.push_back(static_cast<Index>(c));
  }
  return *soup;
}

std::string Rewritten(const std::string& text, const PolygonSoup& textured) {
  std::string out;
  for (const std::string& piece : RewriteObj(text, textured)) out += piece;
  return out;
}

std::string Rewritten(const std::string& text) { return Rewritten(text, WithOwnTexture(text)); }

std::vector<std::string> Lines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    lines.push_back(text.substr(at, end - at));
    at = end;
  }
  return lines;
}

const std::string kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string kNew = "vt 0 0.5\nvt 1 1.5\nvt 2 2.5\n";

TEST(RewriteObj, ChangesNothingButTextureAndCorners) {
  const std::string before =
      "# made by hand\r\n\r\nmtllib a b.mtl\r\no part \r\n  v 0 0 0  1 0 0\r\nvn 0 0 1 # up\r\n"
      "v\t1 0 0 .5 .5 .5\r\nv 1 1 0\r\nv 0 \\\r\n 1 0\r\ng left right\r\nvt 9 9\r\nvt 8 8\r\n"
      "usemtl red\r\ns 1\r\nf 1/1/1 2//1  3/2 # a triangle\r\nl 1/1 2/2 -1\r\np 1 2\r\ng\r\n"
      "usemtl blue\r\n\tf -4//-1 -3/ -2// \\\r\n -1/-1/-1\r\nvt 7 7\r\nf 1 2\r\n# end";
  const std::string after =
      "# made by hand\r\n\r\nmtllib a b.mtl\r\no part \r\n  v 0 0 0  1 0 0\r\nvn 0 0 1 # up\r\n"
      "v\t1 0 0 .5 .5 .5\r\nv 1 1 0\r\nv 0 \\\r\n 1 0\r\ng left right\r\n"
      "vt 0 0.5\r\nvt 1 1.5\r\nvt 2 2.5\r\nvt 3 3.5\r\nvt 4 4.5\r\nvt 5 5.5\r\nvt 6 6.5\r\n"
      "usemtl red\r\ns 1\r\nf 1/1/1 2/2/1  3/3 # a triangle\r\nl 1 2 -1\r\np 1 2\r\ng\r\n"
      "usemtl blue\r\n\tf -4/4/-1 -3/5 -2/6 \\\r\n -1/7/-1\r\nf 1 2\r\n# end";
  EXPECT_EQ(Rewritten(before), after);
  EXPECT_EQ(Rewritten(after), after);
}

TEST(RewriteObj, NewLinesStandBeforeTheFirstOldOneOrFace) {
  EXPECT_EQ(Rewritten(kThree + "g a\nf 1 2 3\n"), kThree + "g a\n" + kNew + "f 1/1 2/2 3/3\n");
  EXPECT_EQ(Rewritten("vt 1 1\n" + kThree + "f 1/1 2 3"), kNew + kThree + "f 1/1 2/2 3/3");
  EXPECT_EQ(Rewritten("\xEF\xBB\xBF"
                      "f 1/1 2 3\n" +
                      kThree + "vt 1 1\n"),
            "\xEF\xBB\xBF" + kNew + "f 1/1 2/2 3/3\n" + kThree);
  EXPECT_EQ(Rewritten("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r"),
            "v 0 0 0\rv 1 0 0\rv 0 1 0\rvt 0 0.5\rvt 1 1.5\rvt 2 2.5\rf 1/1 2/2 3/3\r");
}

TEST(RewriteObj, ACornerWithoutTextureNamesNone) {
  PolygonSoup soup = WithOwnTexture(kThree + "f 1 2 3\n");
  soup.corner_texture = {kNone, 0, kNone};
  soup.texture.resize(1);
  EXPECT_EQ(Rewritten(kThree + "vn 0 0 1\nvt 0 0\nf 1/1/1 2/1/1 3/1\n", soup),
            kThree + "vn 0 0 1\nvt 0 0.5\nf 1//1 2/1/1 3\n");
}

TEST(RewriteObj, TellsWordsFromCommentsAndContinuations) {
  for (const std::string line :
       {"# vt 1 1 \\\n", "usemtl a\\b\n", "vtx 1\n", "fo 1 2 3\n", "f#1 2\n", "vn 0 0 1\\\n 2\n",
        "# f 1 2 3\n", "o f 1 2 3 \\\n f 1 2 3\n", "\\\n\n", "v 1.#INF 0 0 \\\n\n", "surfer\n"}) {
    SCOPED_TRACE(line);
    const bool is_face = line.starts_with("f#");
    EXPECT_EQ(Rewritten(kThree + line + "f 1 2 3\n"),
              kThree + (is_face ? kNew + line : line + kNew) + "f 1/1 2/2 3/3\n");
  }
  EXPECT_EQ(Rewritten(kThree + "\\\nf 1 \\\n2 3#\n"),
            kThree + "\\\n" + kNew + "f 1/1 \\\n2/2 3/3#\n");
  EXPECT_EQ(Rewritten(kThree + "vt \\\n 1 \\\n 1\nf 1 2 3\n"), kThree + kNew + "f 1/1 2/2 3/3\n");
}

/// What is left where something is dropped is not joined to what stands around it.
TEST(RewriteObj, WhatIsDroppedJoinsNoNeighbours) {
  const std::string mark = "\xEF\xBB\xBF";
  const std::string face = "f 1/1 2/2 3/3";
  // A word that begins with a mark would begin the file, which a reader skips.
  EXPECT_EQ(Rewritten("vt 1 1\n" + kThree + mark + "f 1 2\nf 1 2 3"),
            kNew + kThree + mark + "f 1 2\n" + face);
  EXPECT_EQ(Rewritten("vt 1 1\n" + mark + "f 1 2 3\n", {}), mark + mark + "f 1 2 3\n");
  // A carriage return and a newline with a line of texture between them would be one line's end.
  EXPECT_EQ(Rewritten("vt 0 0\n#\rvt 1 1\n\n" + kThree + "f 1 2 3"),
            kNew + "#\r\n\n" + kThree + face);
  EXPECT_EQ(Rewritten("#\rv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 1 1\n\nf 1 2 3"),
            "#\r" + kThree + kNew + "\n" + face);
  // Nor are words that are no references cut: "1.//" would be one word with the comment behind it.
  for (const std::string line : {"l 1.//#INF\n", "l 1\\/\n", "l a/1 //\n"}) {
    EXPECT_EQ(Rewritten(kThree + line + "f 1 2 3"), kThree + line + kNew + face);
  }
  EXPECT_EQ(Rewritten(kThree + "l 1/1 -2/1\nf 1 2 3"), kThree + "l 1 -2\n" + kNew + face);
}

/// Long enough for several stretches, with every kind of line along the way.
TEST(RewriteObj, OfALargeFileOnlyTextureLinesAndCornersDiffer) {
  constexpr int kFaces = 20000;
  std::string text = "mtllib m.mtl\n";
  for (int i = 0; i < kFaces; ++i) {
    text += "v " + std::to_string(i) + " 0 0 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nvn 0 0 1\nvt 3 4\n";
    if (i % 7 == 0) text += "g group" + std::to_string(i) + "\nusemtl m\n";
    if (i % 5 == 0) text += "# \\\nl -1/1 -2\n";
    text += i % 3 == 0 ? "f -4/1/-1 -3//-1 \\\n-2/-1 -1\n" : "f -4 -3/1 -1\n";
  }
  const PolygonSoup soup = WithOwnTexture(text);
  const std::string out = Rewritten(text, soup);
  const PolygonSoup again = *ParseObj("m.obj", out);
  EXPECT_EQ(again.position, soup.position);
  EXPECT_EQ(again.first_corner, soup.first_corner);
  EXPECT_EQ(again.corner, soup.corner);
  EXPECT_EQ(again.texture, soup.texture);
  EXPECT_EQ(again.corner_texture, soup.corner_texture);
  const auto kept = [](const std::string& whole) {
    std::vector<std::string> lines = Lines(whole);
    std::erase_if(lines, [](const std::string& line) {
      return line[0] == 'f' || line[0] == 'l' || line[0] == '-' || line.starts_with("vt");
    });
    return lines;
  };
  EXPECT_EQ(kept(out), kept(text));
  EXPECT_GT(kept(out).size(), 5u * kFaces);
}

/// Whatever the bytes: what can be read is the same mesh when it is rewritten.
TEST(RewriteObj, OfDamagedFilesIsTheSameMesh) {
  const std::string valid =
      "# c\r\nv 0 0 0\r\nv 1 0 0\nv 0 1 \\\r\n0\nvt 1 1\r\nl 1/1 2\nf -3/1 \\\n 2//1 3/-1/1\r\n"
      "# e \\\nf 1 2\nf 1 2 3 3 # f \\\n\xEF\xBB\xBF# \\\nf 3 2 1\nv 1.#IND 0 0 \\\n\nf 1 2 3";
  std::mt19937 random(3);
  int meshes = 0;
  for (int round = 0; round < 4000; ++round) {
    const std::string text = round == 0 ? valid : testing::Mutate(valid, &random);
    if (!ParseObj("m.obj", text).ok()) continue;
    SCOPED_TRACE(text);
    const PolygonSoup soup = WithOwnTexture(text);
    const std::string out = Rewritten(text, soup);
    const StatusOr<PolygonSoup> again = ParseObj("m.obj", out);
    ASSERT_TRUE(again.ok()) << again.status().message();
    ASSERT_EQ(again->position.size(), soup.position.size());
    ASSERT_EQ(again->corner, soup.corner);
    ASSERT_EQ(again->first_corner, soup.first_corner);
    ASSERT_EQ(again->texture, soup.texture);
    ASSERT_EQ(again->corner_texture, soup.corner_texture);
    ASSERT_EQ(Rewritten(out, soup), out);
    ++meshes;
  }
  EXPECT_GT(meshes, 1000);
}

TEST(WriteTexturedMesh, KeepsTheTextOfAnObjAndNoOther) {
  const TemporaryFolder folder;
  const std::string text = "# mine\n" + kThree + "f 1 2 3\n";
  const std::string in = folder.Write("in.obj", text);
  MeshFile file = *ReadMeshFile(in);
  EXPECT_EQ(file.text, text);
  const PolygonSoup textured = WithOwnTexture(text);
  const std::string out = folder.Path("out.obj");
  ASSERT_TRUE(WriteTexturedMesh(out, file, textured).ok());
  EXPECT_EQ(folder.Read("out.obj"), "# mine\n" + kThree + kNew + "f 1/1 2/2 3/3\n");
  // Other polygons than the file's are written by themselves.
  PolygonSoup turned = textured;
  std::swap(turned.corner[0], turned.corner[1]);
  ASSERT_TRUE(WriteTexturedMesh(out, file, turned).ok());
  EXPECT_EQ(folder.Read("out.obj"), kThree + kNew + "f 2/1 1/2 3/3\n");
  ASSERT_TRUE(WriteTexturedMesh(folder.Path("out.ply"), file, textured).ok());
  EXPECT_EQ(ReadMesh(folder.Path("out.ply"))->texture, textured.texture);
  PolygonSoup infinite = textured;
  infinite.texture[2].y() = INFINITY;
  EXPECT_EQ(WriteTexturedMesh(out, file, infinite).message(),
            out + ": texture coordinate 3 (counted from 1) is not finite; no such mesh is written");
}

}  // namespace
}  // namespace cirque

// Every format of the table of formats (io/io.cc), and CON.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/io/con_file.h"
#include "cirque/io/file_input.h"
#include "cirque/io/io.h"
#include "cirque/io/mesh_formats.h"
#include "cirque/io/unpack.h"
#include "cirque/mesh/preflight.h"

#include "tests/fuzz/fuzz_target.h"
#include "tests/io/gzip.h"
#include "tests/io/om_bytes.h"

namespace cirque::testing {
namespace {

/// A 3 x 3 grid of quadrilaterals, or of triangles, bulging.
PolygonSoup Grid(bool triangles) {
  constexpr int kSide = 4;
  PolygonSoup soup;
  for (int v = 0; v < kSide * kSide; ++v) {
    const int x = v % kSide, y = v / kSide;
    soup.position.emplace_back(x, y, 0.25 * x * y);
  }
  for (int v = 0; v + kSide + 1 < kSide * kSide; ++v) {
    if (v % kSide == kSide - 1) continue;
    const std::int64_t a = v, b = v + 1, c = v + kSide + 1, d = v + kSide;
    if (triangles) {
      CHECK_EQ(AddPolygon({a, b, c}, &soup) + AddPolygon({a, c, d}, &soup), "");
    } else {
      CHECK_EQ(AddPolygon({a, b, c, d}, &soup), "");
    }
  }
  return soup;
}

std::string Joined(const TextPieces& pieces) {
  std::string text;
  for (const std::string& piece : pieces) text += piece;
  return text;
}

template <class Point>
bool SameBits(const std::vector<Point>& a, const std::vector<Point>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (Eigen::Index k = 0; k < a[i].size(); ++k) {
      if (std::bit_cast<std::uint64_t>(a[i][k]) != std::bit_cast<std::uint64_t>(b[i][k]))
        return false;
    }
  }
  return true;
}

void CheckSoup(const PolygonSoup& soup) {
  CHECK_GE(soup.first_corner.size(), 1u);
  CHECK_EQ(soup.first_corner.front(), 0);
  CHECK_EQ(static_cast<std::size_t>(soup.first_corner.back()), soup.corner.size());
  for (Index p = 0; p < soup.num_polygons(); ++p) {
    CHECK_GE(soup.first_corner[p + 1] - soup.first_corner[p], 3);
  }
  for (const Index v : soup.corner) {
    CHECK(v >= 0 && v < static_cast<Index>(soup.position.size())) << v;
  }
  CHECK(soup.corner_texture.empty() || soup.corner_texture.size() == soup.corner.size());
  for (const Index t : soup.corner_texture) {
    CHECK(t == kNone || (t >= 0 && t < static_cast<Index>(soup.texture.size()))) << t;
  }
}

/// The point of every corner, and its texture coordinates (0 where it has none).
struct Corners {
  std::vector<Eigen::Vector3d> point;
  std::vector<Eigen::Vector2d> texture;
};

Corners CornersOf(const PolygonSoup& soup) {
  Corners corners;
  for (std::size_t c = 0; c < soup.corner.size(); ++c) {
    corners.point.push_back(soup.position[soup.corner[c]]);
    const Index t = soup.corner_texture.empty() ? kNone : soup.corner_texture[c];
    corners.texture.push_back(t == kNone ? Eigen::Vector2d::Zero().eval() : soup.texture[t]);
  }
  return corners;
}

bool HasTextureAtEveryCorner(const PolygonSoup& soup) {
  return !soup.texture.empty() && std::find(soup.corner_texture.begin(), soup.corner_texture.end(),
                                            kNone) == soup.corner_texture.end();
}

/// What can be written reads back to the same bits; where vertices are split for their texture,
/// corner by corner.
void CheckRoundTrip(const std::string& path, const PolygonSoup& soup) {
  const StatusOr<TextPieces> text = FormatMesh(path, soup);
  if (!text.ok()) return CheckRefusal(text.status(), path);
  const StatusOr<PolygonSoup> again = ParseMesh(path, Joined(*text));
  CHECK(again.ok()) << again.status().message();
  CHECK(soup.first_corner == again->first_corner);
  const bool keeps_vertices = soup.texture.empty() || MeshExtension(path) == "obj";
  if (keeps_vertices) {
    CHECK(SameBits(soup.position, again->position) && SameBits(soup.texture, again->texture));
    CHECK(soup.corner == again->corner && soup.corner_texture == again->corner_texture);
  }
  const Corners before = CornersOf(soup), after = CornersOf(*again);
  CHECK(SameBits(before.point, after.point));
  if (HasTextureAtEveryCorner(soup)) CHECK(SameBits(before.texture, after.texture));
}

/// GLB, which is not read: its parts are as long as they say.
void CheckGlb(const PolygonSoup& soup) {
  const StatusOr<TextPieces> pieces = FormatMesh("a.glb", soup);
  if (!pieces.ok()) return CheckRefusal(pieces.status(), "a.glb");
  const std::string bytes = Joined(*pieces);
  const auto number = [&](std::size_t at) {
    return ReadBytes<std::uint32_t>(std::string_view(bytes).substr(at), ByteOrder::kLittle);
  };
  CHECK_EQ(number(8), bytes.size());
  CHECK_EQ(number(20 + number(12)) + number(12) + 28, bytes.size());
}

/// Numbers in every spelling that readers meet.
const std::vector<std::string> kNumberWords = {
    "0",           "-1",   "1.5",  "1e-3",       "1e400",  "-0",
    "+1",          "nan",  "inf",  "4294967295", "0x1",    "1e-400",
    "#",           "\\\n", "\r\n", "-1.#IND",    "1.#INF", "9223372036854775808",
    "\xEF\xBB\xBF"};

std::vector<std::string> WithNumbers(std::vector<std::string> words) {
  words.insert(words.end(), kNumberWords.begin(), kNumberWords.end());
  return words;
}

void RunMesh(const std::string& path, std::string_view bytes) {
  const StatusOr<PolygonSoup> soup = ParseMesh(path, bytes);
  if (!soup.ok()) return CheckRefusal(soup.status(), path);
  CheckSoup(*soup);
  PreflightReport report;
  const StatusOr<Surface> surface = Preflight(*soup, &report);
  CHECK_NE(surface.ok(), !surface.status().message().empty());
  CheckRoundTrip(path, *soup);
  CheckGlb(*soup);
}

/// An obj rewritten with a texture coordinate of each corner's own is the same mesh with that
/// texture, and rewritten again the same text.
void RunRewrite(std::string_view bytes) {
  StatusOr<PolygonSoup> soup = ParseObj("a.obj", bytes);
  if (!soup.ok()) return CheckRefusal(soup.status(), "a.obj:");
  soup->texture.clear();
  soup->corner_texture.clear();
  for (std::size_t c = 0; c < soup->corner.size(); ++c) {
    soup->texture.emplace_back(c, 0.5);
    soup->corner_texture.push_back(static_cast<Index>(c));
  }
  const std::string once = Joined(RewriteObj(bytes, *soup));
  const StatusOr<PolygonSoup> again = ParseObj("a.obj", once);
  CHECK(again.ok()) << again.status().message();
  CHECK(SameBits(soup->position, again->position) || !soup->not_finite_at.empty());
  CHECK(soup->first_corner == again->first_corner && soup->corner == again->corner);
  CHECK(SameBits(soup->texture, again->texture));
  CHECK(soup->corner_texture == again->corner_texture);
  CHECK(once == Joined(RewriteObj(once, *soup)));
}

/// Packed bytes: what comes out is bounded, and unpacks to itself.
void RunUnpack(std::string_view bytes) {
  std::vector<std::string> warnings;
  const StatusOr<std::string> unpacked = Unpacked("a", std::string(bytes), &warnings);
  if (!unpacked.ok()) return CheckRefusal(unpacked.status(), "a:");
  CHECK_LE(unpacked->size(), std::max(std::size_t{1} << 21, 2 * kMostSwelling * bytes.size()));
  for (const std::string& warning : warnings) CHECK(warning.starts_with("a: "));
}

std::map<std::string, std::vector<std::string>> WordsOfFormats() {
  return {{"obj", {"v ", "vt ", "vn ", "f ", "g ", "usemtl ", "/", "//", "f 1/1/1 2/2/2 3/3/3\n"}},
          {"off", {"OFF\n", "COFF", "NOFF", "STOFF", "BINARY\n", "3 0 1 2\n", "4 0 1 2 3\n"}},
          {"ply",
           {"ply\n",
            "format ascii 1.0\n",
            "format binary_little_endian 1.0\n",
            "format binary_big_endian 1.0\n",
            "element vertex ",
            "element face ",
            "property ",
            "list ",
            "char",
            "uchar",
            "short",
            "ushort",
            "int",
            "uint",
            "float",
            "double",
            "int8",
            "uint8",
            "int16",
            "uint16",
            "int32",
            "uint32",
            "float32",
            "float64",
            " x\n",
            " y\n",
            " z\n",
            "vertex_indices",
            "element tristrips ",
            "vertex_index",
            "end_header\n",
            "comment ",
            "obj_info "}},
          {"stl",
           {"solid ", "facet ", "normal ", "outer loop\n", "vertex ", "endloop\n", "endfacet\n",
            "endsolid", "end "}}};
}

template <class T>
void AppendBytes(T value, std::string* bytes) {
  bytes->append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// The corners of the grid's triangles, as binary STL has them.
std::string BinaryStl() {
  const PolygonSoup soup = Grid(true);
  std::string bytes(80, ' ');
  AppendBytes(static_cast<std::uint32_t>(soup.num_polygons()), &bytes);
  for (Index p = 0; p < soup.num_polygons(); ++p) {
    for (int k = 0; k < 3; ++k) AppendBytes(0.0F, &bytes);
    for (int k = 0; k < 3; ++k) {
      for (const double x : soup.position[soup.corner[3 * p + k]]) {
        AppendBytes(static_cast<float>(x), &bytes);
      }
    }
    AppendBytes(std::uint16_t{0}, &bytes);
  }
  return bytes;
}

/// Two triangles in the byte order of this machine, a list before the corners.
std::string BinaryPly() {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty double "
      "y\nproperty short z\nproperty uchar red\nelement face 2\nproperty list int uchar a\n"
      "property list uchar int vertex_indices\nend_header\n";
  for (int v = 0; v < 4; ++v) {
    AppendBytes(static_cast<float>(v % 2), &bytes);
    AppendBytes(static_cast<double>(v / 2), &bytes);
    AppendBytes(std::int16_t{0}, &bytes);
    bytes += '\x7f';
  }
  for (const std::int32_t first : {0, 1}) {
    AppendBytes(std::int32_t{1}, &bytes);
    bytes += "\x05\x03";
    for (const std::int32_t v : {first, first == 0 ? 1 : 3, 2}) AppendBytes(v, &bytes);
  }
  return bytes;
}

/// A triangle as binary OFF, with a colour.
std::string BinaryOff() {
  std::string bytes = "OFF BINARY\n";
  const auto append = [&](std::uint32_t value) {  // big-endian
    for (int shift = 24; shift >= 0; shift -= 8)
      bytes += static_cast<char>((value >> shift) & 0xFF);
  };
  constexpr std::uint32_t kOne = 0x3F800000;  // 1.0F
  for (const std::uint32_t value :
       {3U, 1U, 0U, 0U, 0U, 0U, kOne, 0U, 0U, 0U, kOne, 0U, 3U, 0U, 1U, 2U, 1U, kOne}) {
    append(value);
  }
  return bytes;
}

constexpr char kStrips[] =
    "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float "
    "z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 "
    "0\n1 1 0\n0 2 0\n7 0 1 2 3 -1 4 3 2\n";

/// Files by hand: of formats that are only read, and variants that are never written.
std::multimap<std::string, std::string> Handmade() {
  return {
      {"obj",
       "# by hand\nmtllib a.mtl\nv 0 0 0 1\nv 1 0 0\nv 0 1 \\\n0\nvt 0 0\nvt .5\nvn 0 0 1\ng a\n"
       "f -1/1 2//1 1/-1/1\n"},
      {"obj",
       "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n"},
      {"off", "COFF 3 1 0\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2 1 1 1\n"},
      {"off", BinaryOff()},
      {"off", "STOFF 3 1\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n"},
      {"ply", BinaryPly()},
      {"ply", kStrips},
      {"om", OmOfQuadrilateral()},
      {"stl", BinaryStl()},
      {"stl",
       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
       "endloop\nendfacet\nendsolid a\n"}};
}

std::vector<std::string> SeedsOf(const std::string& extension) {
  std::vector<std::string> seeds;
  const auto handmade = Handmade();
  for (auto [at, end] = handmade.equal_range(extension); at != end; ++at) {
    seeds.push_back(at->second);
  }
  for (const bool triangles : {false, true}) {
    const StatusOr<TextPieces> text = FormatMesh("a." + extension, Grid(triangles));
    if (text.ok()) seeds.push_back(Joined(*text));
  }
  return seeds;
}

void RunCon(std::string_view bytes) {
  const StatusOr<ConMesh> mesh = ParseCon("a.con", bytes);
  if (!mesh.ok()) return CheckRefusal(mesh.status(), "a.con:");
  const Triangulation& t = mesh->triangulation;
  const std::string text = FormatCon(t, mesh->lengths);
  const StatusOr<ConMesh> again = ParseCon("a.con", text);
  CHECK(again.ok()) << again.status().message();
  CHECK(t.vertex == again->triangulation.vertex && t.twin == again->triangulation.twin);
  CHECK(text == FormatCon(again->triangulation, again->lengths));
}

std::vector<FuzzTarget> FileTargets() {
  std::vector<std::string> objs = SeedsOf("obj");
  objs.push_back(
      "# c\r\nv 0 0 0\r\nv 1 0 0\r\nv 0 1 \\\r\n0\r\nvt 1 1\r\nl 1/1 2\r\nf -3/1 \\\r\n 2//1 "
      "3/-1/1\r\nf 1 2\r\n");
  return {{"obj_rewrite",
           RunRewrite,
           WithNumbers({"v ", "vt ", "f ", "l ", "surf ", "/", "//", "\r\n", "\r", "f 1/1 2 3\n"}),
           objs,
           {"framework/cirque/io/obj_rewrite"}},
          {"unpack",
           RunUnpack,
           {"\x1f\x8b\x08", "\xFF\xFE", "\xFE\xFF"},
           {Gzipped("v 0 0 0\n"), Gzipped("a") + Gzipped("b"),
            std::string("\xFF\xFEv\0\x3D\xD8\x00\xDE", 8)},
           {"framework/cirque/io/unpack"}}};
}

}  // namespace

std::vector<FuzzTarget> MeshTargets() {
  std::vector<FuzzTarget> targets = FileTargets();
  const auto words = WordsOfFormats();
  for (const std::string& extension : ReadableExtensions()) {
    const auto known = words.find(extension);
    targets.push_back(
        {extension,
         [path = "a." + extension](std::string_view bytes) { RunMesh(path, bytes); },
         WithNumbers(known == words.end() ? std::vector<std::string>() : known->second),
         SeedsOf(extension),
         {"framework/cirque/io/" + extension}});
  }
  targets.push_back({"con",
                     RunCon,
                     WithNumbers({"f ", "\n", "3 1\n", "1 2 3 1 1 1 0 0 0\n"}),
                     {"3 1\nf 1 2 3 1 1 1 0 0 0\n", "4 2\n1 2 3\n1 1 1\n1 3 4\n1 1 1\n",
                      "4 2\nf 1 2 3 1 1 1 0 6 0\nf 2 1 4 1 1 1 0 0 2\n",
                      "4\n4\n1 2 3 1 1 1\n1 3 4 1 1 1\n1 4 2 1 1 1\n2 4 3 1 1 1\n",
                      "1 2\nf 1 1 1 1 1 1 4 5 6\nf 1 1 1 1 1 1 1 2 3\n"},
                     {"framework/cirque/io/con_"}});
  return targets;
}

}  // namespace cirque::testing

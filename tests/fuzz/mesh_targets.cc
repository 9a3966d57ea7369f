// Every format of the table of formats (io/io.cc), and CON.
#include <bit>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/io/con_file.h"
#include "cirque/io/io.h"
#include "cirque/mesh/preflight.h"

#include "tests/fuzz/fuzz_target.h"

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

/// What can be written reads back to the same bits.
void CheckRoundTrip(const std::string& path, const PolygonSoup& soup) {
  const StatusOr<TextPieces> text = FormatMesh(path, soup);
  if (!text.ok()) return CheckRefusal(text.status(), path);
  const StatusOr<PolygonSoup> again = ParseMesh(path, Joined(*text));
  CHECK(again.ok()) << again.status().message();
  CHECK(SameBits(soup.position, again->position) && SameBits(soup.texture, again->texture));
  CHECK(soup.first_corner == again->first_corner && soup.corner == again->corner);
  CHECK(soup.corner_texture == again->corner_texture);
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
}

std::map<std::string, std::vector<std::string>> WordsOfFormats() {
  return {{"obj", {"v ", "vt ", "vn ", "f ", "g ", "usemtl ", "/", "//", "f 1/1/1 2/2/2 3/3/3\n"}},
          {"off", {"OFF\n", "COFF", "NOFF", "STOFF", "3 0 1 2\n", "4 0 1 2 3\n"}},
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
            "vertex_index",
            "end_header\n",
            "comment ",
            "obj_info "}},
          {"stl",
           {"solid ", "facet ", "normal ", "outer loop\n", "vertex ", "endloop\n", "endfacet\n",
            "endsolid"}}};
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

/// Files by hand: of formats that are only read, and variants that are never written.
std::multimap<std::string, std::string> Handmade() {
  return {
      {"obj",
       "# by hand\nmtllib a.mtl\nv 0 0 0 1\nv 1 0 0\nv 0 1 \\\n0\nvt 0 0\nvt .5\nvn 0 0 1\ng a\n"
       "f -1/1 2//1 1/-1/1\n"},
      {"obj",
       "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n"},
      {"off", "COFF 3 1 0\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2 1 1 1\n"},
      {"ply", BinaryPly()},
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

}  // namespace

std::vector<FuzzTarget> MeshTargets() {
  std::vector<FuzzTarget> targets;
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
  targets.push_back(
      {"con",
       RunCon,
       WithNumbers({"f ", "\n", "3 1\n", "1 2 3 1 1 1 0 0 0\n"}),
       {"3 1\nf 1 2 3 1 1 1 0 0 0\n", "4 2\nf 1 2 3 1 1 1 0 6 0\nf 2 1 4 1 1 1 0 0 2\n",
        "4\n4\n1 2 3 1 1 1\n1 3 4 1 1 1\n1 4 2 1 1 1\n2 4 3 1 1 1\n",
        "1 2\nf 1 1 1 1 1 1 4 5 6\nf 1 1 1 1 1 1 1 2 3\n"},
       {"framework/cirque/io/con_"}});
  return targets;
}

}  // namespace cirque::testing

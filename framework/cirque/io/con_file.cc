#include "cirque/io/con_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/core/atomic_file.h"
#include "cirque/core/grouping.h"
#include "cirque/io/file_input.h"
#include "cirque/io/text_writer.h"

namespace cirque {
namespace {

constexpr long long kMaxFaces = std::numeric_limits<Index>::max() / 3;
constexpr double kLengthTolerance = 1e-12;  // relative, of glued sides

constexpr std::string_view kLegend =
    "# CON: connectivity and edge lengths. First line: numbers of vertices and faces; then a line "
    "a face:\n"
    "# f v0 v1 v2 l0 l1 l2 n0 n1 n2: vertices counted from 1, counter-clockwise; l_k the length of "
    "side k,\n"
    "# opposite v_k; n_k the side it is glued to, 0 on the boundary. Side k of face i (k from 0, i "
    "from 1)\n"
    "# has number 3 (i - 1) + k + 1.\n";

/// The faces that a CON file lists, before their gluing is known to be one.
struct ConFaces {
  Index num_vertices = 0;
  std::vector<Index> vertex;   ///< 3F, counted from 0
  std::vector<double> length;  ///< 3F
  std::vector<Index> twin;     ///< 3F, kNone on the boundary; empty: the file does not say
  std::vector<int> line;       ///< F: where each face stands in the file
};

/// Why no triangle has these sides; empty when one does.
std::string TriangleProblem(const double* length) {
  for (int k = 0; k < 3; ++k) {
    if (!(length[k] > 0) || !std::isfinite(length[k])) {
      return fmt::format("l{} = {} is no length: expected a positive, finite number", k, length[k]);
    }
  }
  const int k = static_cast<int>(std::max_element(length, length + 3) - length);
  const double a = length[(k + 1) % 3], b = length[(k + 2) % 3];
  const bool is_triangle = std::min(a, b) > length[k] - std::max(a, b);
  return is_triangle ? ""
                     : fmt::format("no triangle has these sides: l{} = {} is not below {} + {}", k,
                                   length[k], a, b);
}

class ConParser {
 public:
  ConParser(const std::string& path, std::string_view text) : scanner_(path, text) {}

  StatusOr<ConFaces> Parse() {
    Status status = ParseHeader();
    for (long long f = 0; status.ok() && f < num_faces_; ++f) status = ParseFace(f);
    if (status.ok() && scanner_.NextLine()) {
      status = scanner_.Error(fmt::format(
          "more lines follow than the {} faces that the header promises; correct the header",
          num_faces_));
    }
    if (!status.ok()) return status;
    return std::move(faces_);
  }

 private:
  Status ParseHeader() {
    if (!scanner_.NextLine()) return scanner_.Error("the file holds no numbers; is it a CON file?");
    const std::optional<long long> vertices = scanner_.Count();
    // The thesis may have meant a line each.
    if (vertices && scanner_.AtLineEnd()) scanner_.NextLine();
    const std::optional<long long> faces = vertices ? scanner_.Count() : std::nullopt;
    if (!faces || !scanner_.AtLineEnd()) {
      return scanner_.Expected("the numbers of vertices and faces, and nothing else");
    }
    num_faces_ = *faces;
    if (*faces < 1 || *faces > kMaxFaces || *vertices < 1 || *vertices > 3 * *faces) {
      return scanner_.Error(fmt::format(
          "{} vertices and {} faces: expected 1 to {} faces and at most three vertices a face",
          *vertices, *faces, kMaxFaces));
    }
    faces_.num_vertices = static_cast<Index>(*vertices);
    return Status();
  }

  Status ParseFace(long long f) {
    if (!scanner_.NextLine()) {
      return scanner_.Error(
          fmt::format("the file ends after {} faces of {}; is it cut off?", f, num_faces_));
    }
    SkipKeyword();
    if (Status s = ParseVertices(); !s.ok()) return s;
    if (Status s = ParseLengths(); !s.ok()) return s;
    if (f == 0) with_neighbours_ = !scanner_.AtLineEnd();
    if (with_neighbours_) {
      if (Status s = ParseNeighbours(); !s.ok()) return s;
    }
    if (!scanner_.AtLineEnd()) {
      return scanner_.Expected(
          fmt::format("the end of the line after {} numbers, as in the first face's line",
                      with_neighbours_ ? 9 : 6));
    }
    faces_.line.push_back(scanner_.line());
    return Status();
  }

  /// Steps over the word f, which begins no number.
  void SkipKeyword() {
    TextScanner ahead = scanner_;
    if (ahead.Word() == "f") scanner_ = ahead;
  }

  Status ParseVertices() {
    for (int k = 0; k < 3; ++k) {
      const std::optional<long long> v = scanner_.Count();
      if (!v) return scanner_.Expected("three vertices");
      if (*v < 1 || *v > faces_.num_vertices) {
        return scanner_.Error(
            fmt::format("there is no vertex {}: they count from 1 to {}", *v, faces_.num_vertices));
      }
      faces_.vertex.push_back(static_cast<Index>(*v - 1));
    }
    return Status();
  }

  Status ParseLengths() {
    std::array<double, 3> length;
    for (double& l : length) {
      const std::optional<double> number = scanner_.Number();
      if (!number) return scanner_.Expected("three lengths after the vertices");
      l = *number;
      faces_.length.push_back(l);
    }
    const std::string problem = TriangleProblem(length.data());
    return problem.empty() ? Status() : scanner_.Error(problem);
  }

  Status ParseNeighbours() {
    for (int k = 0; k < 3; ++k) {
      const std::optional<long long> side = scanner_.Count();
      if (!side) return scanner_.Expected("three neighbouring sides after the lengths");
      if (*side > 3 * num_faces_) {
        return scanner_.Error(
            fmt::format("there is no side {}: they count from 1 to {}, 0 is the boundary", *side,
                        3 * num_faces_));
      }
      faces_.twin.push_back(static_cast<Index>(*side - 1));
    }
    return Status();
  }

  TextScanner scanner_;
  long long num_faces_ = 0;
  bool with_neighbours_ = false;
  ConFaces faces_;
};

/// Checks the gluing (finding it first where the file is silent) against the invariants of
/// Triangulation, the lengths of glued sides against each other, and that the surface is a
/// connected manifold. Errors are "path:line: ...", faces and vertices counted from 1.
class ConGluer {
 public:
  ConGluer(const std::string& path, ConFaces* faces) : path_(path), faces_(*faces) {}

  Status Glue() {
    if (faces_.twin.empty()) {
      if (Status s = GlueByVertices(); !s.ok()) return s;
    }
    for (Index h = 0; h < static_cast<Index>(faces_.twin.size()); ++h) {
      if (faces_.twin[h] == kNone) continue;
      if (Status s = CheckSide(h, faces_.twin[h]); !s.ok()) return s;
    }
    if (Status s = CheckFans(); !s.ok()) return s;
    return CheckConnected();
  }

 private:
  Index Tail(Index h) const { return faces_.vertex[Triangulation::Next(h)]; }
  Index Tip(Index h) const { return faces_.vertex[Triangulation::Prev(h)]; }

  std::string Name(Index h) const {
    return fmt::format("side {} (of face {}, from vertex {} to {})", h + 1,
                       Triangulation::Face(h) + 1, Tail(h) + 1, Tip(h) + 1);
  }

  Status Error(Index face, const std::string& message) const {
    return Status::InvalidInput(fmt::format("{}:{}: {}", path_, faces_.line[face], message));
  }

  Status ErrorAtSide(Index h, const std::string& message) const {
    return Error(Triangulation::Face(h), Name(h) + " " + message);
  }

  Status GlueByVertices() {
    const auto num_sides = static_cast<Index>(faces_.vertex.size());
    std::vector<Index> order(num_sides);
    std::iota(order.begin(), order.end(), 0);
    const auto ends = [&](Index h) {
      return std::pair(std::min(Tail(h), Tip(h)), std::max(Tail(h), Tip(h)));
    };
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return std::pair(ends(a), a) < std::pair(ends(b), b); });
    faces_.twin.assign(num_sides, kNone);
    for (Index first = 0, last = 0; first < num_sides; first = last) {
      while (last < num_sides && ends(order[last]) == ends(order[first])) ++last;
      if (last - first == 1) continue;
      const Index h = order[first], g = order[first + 1];
      if (last - first > 2) {
        return ErrorAtSide(h, fmt::format("could be glued to {} and to others; add the three "
                                          "neighbouring sides to every face's line",
                                          Name(g)));
      }
      faces_.twin[h] = g;
      faces_.twin[g] = h;
    }
    return Status();
  }

  Status CheckSide(Index h, Index g) const {
    if (g == h) return ErrorAtSide(h, "is glued to itself; 0 says that it is on the boundary");
    if (faces_.twin[g] != h) {
      return ErrorAtSide(h, fmt::format("names {} as its neighbour, which names side {}; both must "
                                        "name each other",
                                        Name(g), faces_.twin[g] + 1));
    }
    if (Tail(g) != Tip(h) || Tip(g) != Tail(h)) {
      return ErrorAtSide(h, fmt::format("is glued to {}; they must run between the same vertices "
                                        "in opposite directions: turn one of the faces around or "
                                        "correct its neighbours",
                                        Name(g)));
    }
    const double a = faces_.length[h], b = faces_.length[g];
    if (std::abs(a - b) > kLengthTolerance * std::max(a, b)) {
      return ErrorAtSide(h,
                         fmt::format("has length {}, but {} on the other side of it has {}; they "
                                     "must agree to {:g} of the length",
                                     a, Name(g), b, kLengthTolerance));
    }
    return Status();
  }

  /// The corners of a vertex must form one fan or one cycle.
  Status CheckFans() const {
    const auto num_corners = static_cast<Index>(faces_.vertex.size());
    DisjointSets fans(num_corners);
    for (Index h = 0; h < num_corners; ++h) {
      const Index g = faces_.twin[h];
      if (g == kNone) continue;
      fans.Unite(Triangulation::Next(h), Triangulation::Prev(g));
      fans.Unite(Triangulation::Prev(h), Triangulation::Next(g));
    }
    std::vector<Index> fan_of(faces_.num_vertices, kNone);
    for (Index h = 0; h < num_corners; ++h) {
      Index& fan = fan_of[faces_.vertex[h]];
      if (fan == kNone) fan = fans.Find(h);
      if (fan == fans.Find(h)) continue;
      return Error(Triangulation::Face(h),
                   fmt::format("vertex {} belongs to face {} and to face {}, which no glued sides "
                               "join around it; give each of its fans a vertex of its own",
                               faces_.vertex[h] + 1, Triangulation::Face(fan) + 1,
                               Triangulation::Face(h) + 1));
    }
    const auto unused = std::find(fan_of.begin(), fan_of.end(), kNone);
    if (unused == fan_of.end()) return Status();
    return Status::InvalidInput(fmt::format(
        "{}: vertex {} belongs to no face; lower the number of vertices and renumber them", path_,
        unused - fan_of.begin() + 1));
  }

  Status CheckConnected() const {
    const auto num_faces = static_cast<Index>(faces_.line.size());
    DisjointSets pieces(num_faces);
    for (Index h = 0; h < 3 * num_faces; ++h) {
      if (faces_.twin[h] == kNone) continue;
      pieces.Unite(Triangulation::Face(h), Triangulation::Face(faces_.twin[h]));
    }
    for (Index f = 0; f < num_faces; ++f) {
      if (pieces.Find(f) == 0) continue;
      return Error(f, fmt::format("face {} is not connected to face 1; put every connected "
                                  "component into a file of its own",
                                  f + 1));
    }
    return Status();
  }

  const std::string& path_;
  ConFaces& faces_;
};

}  // namespace

std::string FormatCon(const Triangulation& t, const EdgeLengths& lengths) {
  CHECK_EQ(lengths.value.size(), t.num_edges());
  TextWriter out;
  out.Text(kLegend);
  out.Text(fmt::format("{} {}\n", t.num_vertices, t.num_faces()));
  const auto put = [&](auto value) {
    out.Text(" ");
    out.Number(value);
  };
  for (Index f = 0; f < t.num_faces(); ++f) {
    out.Text("f");
    for (Index h = 3 * f; h < 3 * f + 3; ++h) put(t.vertex[h] + 1);
    for (Index h = 3 * f; h < 3 * f + 3; ++h) put(lengths.value[t.edge[h]]);
    for (Index h = 3 * f; h < 3 * f + 3; ++h) put(t.twin[h] + 1);
    out.Text("\n");
  }
  return std::move(out).Take();
}

StatusOr<ConMesh> ParseCon(const std::string& path, std::string_view content) {
  StatusOr<ConFaces> faces = ConParser(path, content).Parse();
  if (!faces.ok()) return faces.status();
  if (Status s = ConGluer(path, &*faces).Glue(); !s.ok()) return s;
  ConMesh mesh;
  mesh.triangulation =
      NumberEdges(faces->num_vertices, std::move(faces->vertex), std::move(faces->twin));
  const Triangulation& t = mesh.triangulation;
  mesh.lengths.value.resize(t.num_edges());
  for (Index e = 0; e < t.num_edges(); ++e) {
    mesh.lengths.value[e] = faces->length[t.edge_halfedge[e]];
  }
  return mesh;
}

StatusOr<ConMesh> ReadCon(const std::string& path) {
  const StatusOr<std::string> content = ReadFileContent(path);
  if (!content.ok()) return content.status();
  return ParseCon(path, *content);
}

Status WriteCon(const std::string& path, const Triangulation& t, const EdgeLengths& lengths) {
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (!(lengths.value[e] > 0) || !std::isfinite(lengths.value[e])) {
      return Status::InvalidInput(
          fmt::format("{}: edge {} (0-based) has length {}; no such CON file is written", path, e,
                      lengths.value[e]));
    }
  }
  return WriteFileAtomically(path, FormatCon(t, lengths));
}

}  // namespace cirque

#include "cirque/io/con_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/core/atomic_file.h"
#include "cirque/io/con_gluing.h"
#include "cirque/io/file_input.h"
#include "cirque/io/text_writer.h"
#include "cirque/io/unpack.h"

namespace cirque {
namespace {

constexpr long long kMaxFaces = std::numeric_limits<Index>::max() / 3;

constexpr std::string_view kLegend =
    "# CON: connectivity and edge lengths. First line: numbers of vertices and faces; then a line "
    "a face:\n"
    "# f v0 v1 v2 l0 l1 l2 n0 n1 n2: vertices counted from 1, counter-clockwise; l_k the length of "
    "side k,\n"
    "# opposite v_k; n_k the side it is glued to, 0 on the boundary. Side k of face i (k from 0, i "
    "from 1)\n"
    "# has number 3 (i - 1) + k + 1.\n";

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
    // The thesis has the lengths on a line of their own.
    if (scanner_.AtLineEnd()) scanner_.NextLine();
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

}  // namespace

std::string FormatCon(const Triangulation& t, const EdgeLengths& lengths, ConForm form) {
  CHECK_EQ(lengths.value.size(), t.num_edges());
  const bool is_thesis = form == ConForm::kThesis;
  TextWriter out;
  if (!is_thesis) out.Text(kLegend);
  out.Text(fmt::format("{} {}\n", t.num_vertices, t.num_faces()));
  const auto put = [&](std::string_view before, auto value) {
    out.Text(before);
    out.Number(value);
  };
  for (Index f = 0; f < t.num_faces(); ++f) {
    const Index h = 3 * f;
    put(is_thesis ? "" : "f ", t.vertex[h] + 1);
    for (const Index i : {h + 1, h + 2}) put(" ", t.vertex[i] + 1);
    put(is_thesis ? "\n" : " ", lengths.value[t.edge[h]]);
    for (const Index i : {h + 1, h + 2}) put(" ", lengths.value[t.edge[i]]);
    for (Index k = 0; k < 3 && !is_thesis; ++k) put(" ", t.twin[h + k] + 1);
    out.Text("\n");
  }
  return std::move(out).Take();
}

StatusOr<ConMesh> ParseCon(const std::string& path, std::string_view content) {
  StatusOr<ConFaces> faces = ConParser(path, content).Parse();
  if (!faces.ok()) return faces.status();
  if (Status s = GlueFaces(path, &*faces); !s.ok()) return s;
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
  std::vector<std::string> warnings;  // of packing: it holds what is read, or is refused
  const StatusOr<std::string> content = ReadUnpacked(path, &warnings);
  if (!content.ok()) return content.status();
  return ParseCon(path, *content);
}

Status WriteCon(const std::string& path, const Triangulation& t, const EdgeLengths& lengths,
                ConForm form) {
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (!(lengths.value[e] > 0) || !std::isfinite(lengths.value[e])) {
      return Status::InvalidInput(
          fmt::format("{}: edge {} (0-based) has length {}; no such CON file is written", path, e,
                      lengths.value[e]));
    }
  }
  const std::string content = FormatCon(t, lengths, form);
  if (form == ConForm::kThesis) {
    const StatusOr<ConMesh> again = ParseCon(path, content);
    if (!again.ok() || again->triangulation.twin != t.twin) {
      return Status::InvalidInput(
          path +
          ": the thesis's form cannot tell several edges between the same vertices apart; "
          "write the form with neighbours");
    }
  }
  return WriteFileAtomically(path, content);
}

}  // namespace cirque

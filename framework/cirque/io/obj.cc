#include <charconv>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "cirque/io/file_input.h"
#include "cirque/io/mesh_formats.h"
#include "cirque/io/text_writer.h"

namespace cirque {
namespace {

/// A file may use a vertex before it gives it, so indices beyond what was read so far are judged at
/// the end. The first and largest such index, and the line of it.
struct LatestReference {
  std::int64_t index = -1;  ///< counted from 0
  int line = 0;

  void Take(std::int64_t new_index, int new_line) {
    if (new_index > index) *this = {new_index, new_line};
  }
};

class ObjParser {
 public:
  ObjParser(const std::string& path, std::string_view text)
      : path_(path), scanner_(path, text, TextScanner::Continuation::kBackslash) {}

  StatusOr<PolygonSoup> Parse() {
    while (scanner_.NextLine()) {
      const Status status = ParseLine();
      if (!status.ok()) return status;
    }
    const Status status = JudgeLatestVertex();
    if (!status.ok()) return status;
    DropMissingTexture();
    for (const PassedOver& kind : {few_corners_, no_such_texture_, empty_texture_}) {
      kind.Warn(&soup_);
    }
    return std::move(soup_);
  }

 private:
  Status ParseLine() {
    const std::string_view keyword = scanner_.Word();
    if (keyword == "v") return ParsePosition();
    if (keyword == "f") return ParseFace();
    if (keyword == "vt") return ParseTexture();
    return Status();
  }

  Status ParsePosition() {
    Eigen::Vector3d point;
    for (double& coordinate : point) {
      const std::optional<double> number = scanner_.Number();
      if (!number) return scanner_.Expected("three coordinates, 'v x y z'");
      coordinate = *number;
    }
    soup_.position.push_back(point);
    if (!point.allFinite() && soup_.not_finite_at.empty()) soup_.not_finite_at = scanner_.Place();
    return Status();
  }

  Status ParseTexture() {
    if (scanner_.AtLineEnd()) {
      empty_texture_.At(scanner_);
      has_empty_texture_ = true;
      soup_.texture.emplace_back(0, 0);  // what follows keeps its number
      return Status();
    }
    const std::optional<double> u = scanner_.Number();
    const std::optional<double> v = u && scanner_.AtLineEnd() ? 0.0 : scanner_.Number();
    if (!u || !v) return scanner_.Expected("texture coordinates, 'vt u v'");
    soup_.texture.emplace_back(*u, *v);
    return Status();
  }

  Status ParseFace() {
    while (!scanner_.AtLineEnd()) {
      const Status status = ParseCorner(scanner_.Word());
      if (!status.ok()) return status;
    }
    const auto first = static_cast<std::size_t>(soup_.first_corner.back());
    if (soup_.corner.size() < first + 3) {
      few_corners_.At(scanner_);
      soup_.corner.resize(first);
      soup_.corner_texture.resize(first);
      return Status();
    }
    soup_.first_corner.push_back(static_cast<Index>(soup_.corner.size()));
    return Status();
  }

  /// One word of a face: v, v/vt, v//vn or v/vt/vn.
  Status ParseCorner(std::string_view word) {
    const char* const end = word.data() + word.size();
    std::int64_t index[3] = {0, 0, 0};
    bool given[3] = {false, false, false};
    const char* c = word.data();
    for (int part = 0; part < 3; ++part) {
      const auto [next, error] = std::from_chars(c, end, index[part]);
      given[part] = error == std::errc();
      const bool left_out = part > 0 && (c == end || *c == '/');
      if (!given[part] && !left_out) return NotACorner(word);
      if (next == end) return AddCorner(index[0], given[1], index[1]);
      if (*next != '/') return NotACorner(word);
      c = next + 1;
    }
    return NotACorner(word);
  }

  Status NotACorner(std::string_view word) const {
    return scanner_.Error(
        fmt::format("expected a face corner v, v/vt, v//vn or v/vt/vn, got {}", Quoted(word)));
  }

  Status AddCorner(std::int64_t vertex, bool has_texture, std::int64_t texture) {
    const Status status = ResolveVertex(&vertex);
    soup_.corner.push_back(static_cast<Index>(vertex));
    soup_.corner_texture.push_back(has_texture ? ResolveTexture(texture) : kNone);
    return status;
  }

  /// Turns the file's index into one that counts from 0.
  Status ResolveVertex(std::int64_t* index) {
    const auto known = static_cast<std::int64_t>(soup_.position.size());
    if (*index == 0) {
      return scanner_.Error("vertex index 0; OBJ counts from 1 (or back from -1)");
    }
    if (*index < -known) {
      return scanner_.Error(fmt::format(
          "vertex index {} goes back beyond the first of the {} before it", *index, known));
    }
    *index = *index > 0 ? *index - 1 : known + *index;
    if (*index >= known) latest_vertex_.Take(*index, scanner_.line());
    return Status();
  }

  /// The same; kNone where there is no such texture coordinate.
  Index ResolveTexture(std::int64_t index) {
    const auto known = static_cast<std::int64_t>(soup_.texture.size());
    if (index == 0 || index < -known || index > std::numeric_limits<Index>::max()) {
      no_such_texture_.At(scanner_);
      return kNone;
    }
    index = index > 0 ? index - 1 : known + index;
    if (index >= known) latest_texture_.Take(index, scanner_.line());
    return static_cast<Index>(index);
  }

  Status JudgeLatestVertex() const {
    const std::size_t count = soup_.position.size();
    if (latest_vertex_.index < static_cast<std::int64_t>(count)) return Status();
    return Status::InvalidInput(
        fmt::format("{}; correct the index or check that the file is complete",
                    Missing("vertex", latest_vertex_, count)));
  }

  std::string Missing(const char* kind, const LatestReference& latest, std::size_t count) const {
    return fmt::format("{}:{}: {} index {}, but the file has only {}", path_, latest.line, kind,
                       latest.index + 1, count);
  }

  /// Many programs write indices of texture that they do not write.
  void DropMissingTexture() {
    const std::size_t count = soup_.texture.size();
    if (latest_texture_.index >= static_cast<std::int64_t>(count)) {
      soup_.warnings.push_back(Missing("texture coordinate", latest_texture_, count) +
                               "; such corners have none");
      for (Index& texture : soup_.corner_texture) {
        if (texture != kNone && static_cast<std::size_t>(texture) >= count) texture = kNone;
      }
    }
    if (has_empty_texture_) soup_.texture.clear();
    if (soup_.texture.empty()) soup_.corner_texture.clear();
  }

  const std::string& path_;
  TextScanner scanner_;
  PolygonSoup soup_;
  LatestReference latest_vertex_, latest_texture_;
  bool has_empty_texture_ = false;
  PassedOver few_corners_{kTooFewCorners};
  PassedOver no_such_texture_{
      "there is no such texture coordinate (OBJ counts from 1): the corner has none"};
  PassedOver empty_texture_{
      "'vt' without numbers: all texture coordinates of the file are ignored"};
};

}  // namespace

StatusOr<PolygonSoup> ParseObj(const std::string& path, std::string_view text) {
  return ObjParser(path, text).Parse();
}

namespace {

template <class Point>
void WritePoints(const char* keyword, const std::vector<Point>& points, TextWriter* out) {
  out->Lines(static_cast<int>(points.size()), [&](int i, TextWriter* line) {
    line->Text(keyword);
    line->PointLine(points[i]);
  });
}

void WriteCorner(const PolygonSoup& mesh, Index corner, TextWriter* out) {
  out->Text(" ");
  out->Number(mesh.corner[corner] + 1);
  if (mesh.corner_texture.empty() || mesh.corner_texture[corner] == kNone) return;
  out->Text("/");
  out->Number(mesh.corner_texture[corner] + 1);
}

}  // namespace

TextPieces FormatObj(const PolygonSoup& mesh) { return FormatObjInGroups(mesh, {}); }

namespace {

template <class Texture>
TextPieces FormatWith(const PolygonSoup& mesh, const std::vector<Texture>& texture,
                      const std::vector<Index>& group) {
  TextWriter out;
  WritePoints("v ", mesh.position, &out);
  WritePoints("vt ", texture, &out);
  out.Lines(mesh.num_polygons(), [&](int p, TextWriter* line) {
    if (!group.empty() && (p == 0 || group[p] != group[p - 1])) {
      line->Text("g face_");
      line->Number(group[p] + 1);
      line->Text("\n");
    }
    line->Text("f");
    for (Index c = mesh.first_corner[p]; c < mesh.first_corner[p + 1]; ++c) {
      WriteCorner(mesh, c, line);
    }
    line->Text("\n");
  });
  return std::move(out).TakePieces();
}

}  // namespace

TextPieces FormatObjInGroups(const PolygonSoup& mesh, const std::vector<Index>& group) {
  return FormatWith(mesh, mesh.texture, group);
}

TextPieces FormatHomogeneousObj(const PolygonSoup& mesh,
                                const std::vector<Eigen::Vector3d>& texture,
                                const std::vector<Index>& group) {
  return FormatWith(mesh, texture, group);
}

}  // namespace cirque

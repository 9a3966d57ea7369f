#include <charconv>
#include <cstdint>
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
  std::int64_t index = 0;
  int line = 0;
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
    const Status status = JudgeLatestReferences();
    if (!status.ok()) return status;
    if (soup_.texture.empty()) soup_.corner_texture.clear();
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
    const std::size_t corners = soup_.corner.size() - soup_.first_corner.back();
    if (corners < 3) {
      return scanner_.Error(fmt::format(
          "a face needs at least 3 corners, this one has {}; complete or remove it", corners));
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
    Status status = Resolve("vertex", soup_.position.size(), &latest_vertex_, &vertex);
    if (status.ok() && has_texture) {
      status = Resolve("texture coordinate", soup_.texture.size(), &latest_texture_, &texture);
    }
    soup_.corner.push_back(static_cast<Index>(vertex));
    soup_.corner_texture.push_back(has_texture ? static_cast<Index>(texture) : kNone);
    return status;
  }

  /// Turns the file's index into one that counts from 0.
  Status Resolve(const char* kind, std::size_t count, LatestReference* latest,
                 std::int64_t* index) {
    const std::int64_t known = static_cast<std::int64_t>(count);
    if (*index == 0) {
      return scanner_.Error(fmt::format("{} index 0; OBJ counts from 1 (or back from -1)", kind));
    }
    if (*index < -known) {
      return scanner_.Error(fmt::format(
          "{} index {} goes back beyond the first of the {} before it", kind, *index, known));
    }
    *index = *index > 0 ? *index - 1 : known + *index;
    if (*index >= known && *index + 1 > latest->index) *latest = {*index + 1, scanner_.line()};
    return Status();
  }

  Status JudgeLatestReferences() const {
    const Status status = JudgeLatest("vertex", latest_vertex_, soup_.position.size());
    return status.ok() ? JudgeLatest("texture coordinate", latest_texture_, soup_.texture.size())
                       : status;
  }

  Status JudgeLatest(const char* kind, const LatestReference& latest, std::size_t count) const {
    if (latest.index <= static_cast<std::int64_t>(count)) return Status();
    return Status::InvalidInput(
        fmt::format("{}:{}: {} index {}, but the file has only {}; correct the index or check "
                    "that the file is complete",
                    path_, latest.line, kind, latest.index, count));
  }

  const std::string& path_;
  TextScanner scanner_;
  PolygonSoup soup_;
  LatestReference latest_vertex_, latest_texture_;
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

TextPieces FormatObj(const PolygonSoup& mesh) {
  TextWriter out;
  WritePoints("v ", mesh.position, &out);
  WritePoints("vt ", mesh.texture, &out);
  out.Lines(mesh.num_polygons(), [&](int p, TextWriter* line) {
    line->Text("f");
    for (Index c = mesh.first_corner[p]; c < mesh.first_corner[p + 1]; ++c) {
      WriteCorner(mesh, c, line);
    }
    line->Text("\n");
  });
  return std::move(out).TakePieces();
}

}  // namespace cirque

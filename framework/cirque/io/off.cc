#include <array>
#include <utility>

#include <fmt/format.h>

#include "cirque/io/file_input.h"
#include "cirque/io/mesh_formats.h"
#include "cirque/io/text_writer.h"

namespace cirque {
namespace {

/// Whether it is OFF, possibly with ST, C and N (in this order) in front.
bool IsKeyword(std::string_view word) {
  for (const std::string_view prefix : {"ST", "C", "N"}) {
    if (word.starts_with(prefix)) word.remove_prefix(prefix.size());
  }
  return word == "OFF";
}

class OffParser {
 public:
  OffParser(const std::string& path, std::string_view text) : scanner_(path, text) {}

  StatusOr<PolygonSoup> Parse() {
    Status status = ParseHeader();
    for (long long v = 0; status.ok() && v < num_vertices_; ++v) status = ParseVertex(v);
    for (long long f = 0; status.ok() && f < num_faces_; ++f) status = ParseFace(f);
    if (status.ok() && scanner_.NextLine()) {
      status = scanner_.Error(
          fmt::format("more lines follow than the header promises (vertices: {}, faces: {}); "
                      "correct the header",
                      num_vertices_, num_faces_));
    }
    if (!status.ok()) return status;
    return std::move(soup_);
  }

 private:
  Status ParseHeader() {
    if (!scanner_.NextLine() || !IsKeyword(scanner_.Word())) {
      return scanner_.Error(
          "expected the keyword OFF (or COFF, NOFF, STOFF); is this a text OFF file of points in "
          "space?");
    }
    if (scanner_.AtLineEnd()) scanner_.NextLine();
    const std::optional<long long> vertices = scanner_.Count();
    const std::optional<long long> faces = vertices ? scanner_.Count() : std::nullopt;
    if (!faces) {
      return scanner_.Expected("the numbers of vertices and faces");
    }
    num_vertices_ = *vertices;
    num_faces_ = *faces;
    return Status();
  }

  Status ParseVertex(long long v) {
    if (!scanner_.NextLine()) return EndsEarly("vertex", v, num_vertices_);
    Eigen::Vector3d point;
    for (double& coordinate : point) {
      const std::optional<double> number = scanner_.Number();
      if (!number) return scanner_.Expected("three coordinates of a vertex");
      coordinate = *number;
    }
    soup_.position.push_back(point);
    if (!point.allFinite() && soup_.not_finite_at.empty()) soup_.not_finite_at = scanner_.Place();
    return Status();
  }

  Status ParseFace(long long f) {
    if (!scanner_.NextLine()) return EndsEarly("face", f, num_faces_);
    const std::optional<long long> size = scanner_.Count();
    if (!size) return scanner_.Expected("the number of corners of a face");
    corners_.clear();
    for (long long c = 0; c < *size; ++c) {
      const std::optional<long long> vertex = scanner_.Integer();
      if (!vertex) {
        return scanner_.Expected(fmt::format("{} vertex indices, as the line says", *size));
      }
      corners_.push_back(*vertex);
    }
    const std::string problem = AddPolygon(corners_, &soup_);
    return problem.empty() ? Status() : scanner_.Error(problem);
  }

  Status EndsEarly(const char* kind, long long found, long long promised) const {
    return scanner_.Error(
        fmt::format("the file ends after {} {} of {}; is it cut off?", kind, found, promised));
  }

  TextScanner scanner_;
  long long num_vertices_ = 0, num_faces_ = 0;
  PolygonSoup soup_;
  std::vector<std::int64_t> corners_;
};

}  // namespace

StatusOr<PolygonSoup> ParseOff(const std::string& path, std::string_view text) {
  return OffParser(path, text).Parse();
}

TextPieces FormatOff(const PolygonSoup& mesh) {
  TextWriter out;
  out.Text("OFF\n");
  out.Number(mesh.position.size());
  out.Text(" ");
  out.Number(mesh.num_polygons());
  out.Text(" 0\n");
  WritePointsAndPolygons(mesh, &out);
  return std::move(out).TakePieces();
}

}  // namespace cirque

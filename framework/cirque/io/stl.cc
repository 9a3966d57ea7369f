#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "cirque/io/file_input.h"
#include "cirque/io/mesh_formats.h"

namespace cirque {
namespace {

// 80 bytes of anything, a count; then a triangle: normal, three vertices, two bytes of attributes.
constexpr std::size_t kHeader = 84, kNormal = 12, kTriangle = 50;

std::uint64_t AnnouncedSize(std::string_view content) {
  return kHeader + kTriangle * std::uint64_t{ReadBytes<std::uint32_t>(content.substr(80),
                                                                      ByteOrder::kLittle)};
}

/// The mesh of triangles given by three corners each, equal corners welded.
PolygonSoup Weld(const std::vector<Eigen::Vector3d>& corners) {
  PolygonSoup soup;
  const std::vector<Index> first = FirstOfEqualPoints(corners);
  std::vector<Index> vertex(corners.size());
  for (std::size_t c = 0; c < corners.size(); ++c) {
    if (first[c] == static_cast<Index>(c)) {
      vertex[c] = static_cast<Index>(soup.position.size());
      soup.position.push_back(corners[c]);
    }
    soup.corner.push_back(vertex[first[c]]);
    if (c % 3 == 2) soup.first_corner.push_back(static_cast<Index>(c + 1));
  }
  return soup;
}

PolygonSoup ParseBinary(std::string_view content) {
  std::vector<Eigen::Vector3d> corners;
  for (std::size_t at = kHeader; at < content.size(); at += kTriangle) {
    for (std::size_t k = 0; k < 3; ++k) {
      Eigen::Vector3d& corner = corners.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const std::string_view bytes = content.substr(at + kNormal + 12 * k + 4 * i);
        corner[static_cast<int>(i)] =
            static_cast<double>(ReadBytes<float>(bytes, ByteOrder::kLittle));
      }
    }
  }
  return Weld(corners);
}

class StlTextParser {
 public:
  StlTextParser(const std::string& path, std::string_view text) : scanner_(path, text) {}

  StatusOr<PolygonSoup> Parse() {
    while (scanner_.NextLine()) {
      const Status status = ParseSolid();
      if (!status.ok()) return status;
    }
    PolygonSoup soup = Weld(corners_);
    soup.not_finite_at = not_finite_at_;
    return soup;
  }

 private:
  /// From the line `solid NAME` to the line `endsolid NAME`.
  Status ParseSolid() {
    Status status = ExpectWord("solid");
    while (status.ok()) {
      if (!scanner_.NextLine()) return EndsEarly();
      const std::string_view word = scanner_.Word();
      if (word == "endsolid") return Status();
      status = word == "facet" ? ParseFacet() : NotAFacet(word);
    }
    return status;
  }

  /// The lines after `facet`.
  Status ParseFacet() {
    Status status = NextLineIs("outer");
    for (int k = 0; status.ok() && k < 3; ++k) {
      status = NextLineIs("vertex");
      if (status.ok()) status = ParseCorner();
    }
    if (status.ok()) status = NextLineIs("endloop");
    return status.ok() ? NextLineIs("endfacet") : status;
  }

  Status ParseCorner() {
    Eigen::Vector3d& corner = corners_.emplace_back();
    for (double& coordinate : corner) {
      const std::optional<double> number = scanner_.Number();
      if (!number) return scanner_.Expected("three coordinates, 'vertex x y z'");
      coordinate = *number;
    }
    if (!corner.allFinite() && not_finite_at_.empty()) not_finite_at_ = scanner_.Place();
    return Status();
  }

  Status NextLineIs(std::string_view keyword) {
    return scanner_.NextLine() ? ExpectWord(keyword) : EndsEarly();
  }

  Status ExpectWord(std::string_view keyword) {
    const std::string_view word = scanner_.Word();
    if (word == keyword) return Status();
    return scanner_.Error(fmt::format("expected '{}', got {}", keyword, Quoted(word)));
  }

  Status NotAFacet(std::string_view word) const {
    return scanner_.Error(fmt::format("expected 'facet' or 'endsolid', got {}", Quoted(word)));
  }

  Status EndsEarly() const {
    return scanner_.Error("the file ends before 'endsolid'; is it cut off?");
  }

  TextScanner scanner_;
  std::vector<Eigen::Vector3d> corners_;
  std::string not_finite_at_;
};

}  // namespace

StatusOr<PolygonSoup> ParseStl(const std::string& path, std::string_view content) {
  if (content.size() >= kHeader && content.size() == AnnouncedSize(content)) {
    return ParseBinary(content);
  }
  if (content.starts_with("solid")) return StlTextParser(path, content).Parse();
  if (content.size() < kHeader) {
    return Status::InvalidInput(fmt::format(
        "{}: neither text STL (it does not start with 'solid') nor binary (it is shorter than {} "
        "bytes); is it cut off?",
        path, kHeader));
  }
  return Status::InvalidInput(
      fmt::format("{}: a binary STL file with the count in its header has {} bytes, this one has "
                  "{}; is it cut off, or not STL?",
                  path, AnnouncedSize(content), content.size()));
}

}  // namespace cirque

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/count.h"
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

/// @pre at least as many bytes as announced.
PolygonSoup ParseBinary(const std::string& path, std::string_view content) {
  std::vector<Eigen::Vector3d> corners;
  std::string not_finite_at;
  const auto size = static_cast<std::size_t>(AnnouncedSize(content));
  for (std::size_t at = kHeader; at < size; at += kTriangle) {
    for (std::size_t k = 0; k < 3; ++k) {
      Eigen::Vector3d& corner = corners.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const std::string_view bytes = content.substr(at + kNormal + 12 * k + 4 * i);
        corner[static_cast<int>(i)] =
            static_cast<double>(ReadBytes<float>(bytes, ByteOrder::kLittle));
      }
      if (!corner.allFinite() && not_finite_at.empty()) {
        not_finite_at = fmt::format("{}: byte {}", path, at + kNormal + 12 * k);
      }
    }
  }
  PolygonSoup soup = Weld(corners);
  soup.not_finite_at = not_finite_at;
  if (content.size() > size) {
    soup.warnings.push_back(
        fmt::format("{}: what is behind the announced triangles, {}, is ignored", path,
                    Count(content.size() - size, "byte")));
  }
  return soup;
}

std::string Lower(std::string_view word) {
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

/// Reads word by word: programs differ in capitals, in line ends and in `end solid`.
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
  /// From `solid NAME` to the line `endsolid NAME`.
  Status ParseSolid() {
    Status status = Expect("solid");
    if (!scanner_.NextLine()) return EndsEarly();  // the name
    while (status.ok()) {
      const std::string word = Next();
      if (word.empty()) return EndsEarly();
      if (word == "endsolid" || (word == "end" && Next() == "solid")) return Status();
      status = word == "facet" ? ParseFacet() : NotAFacet(word);
    }
    return status;
  }

  /// What follows `facet`: `normal`, three numbers that are not read, and the corners.
  Status ParseFacet() {
    constexpr int kMostWords = 4;
    std::string word = Next();
    for (int i = 0; i < kMostWords && word != "outer"; ++i) word = Next();
    if (word != "outer") return NotThe("outer", word);
    Status status = Expect("loop");
    for (int k = 0; status.ok() && k < 3; ++k) {
      status = Expect("vertex");
      if (status.ok()) status = ParseCorner();
    }
    if (status.ok()) status = ExpectEnd("loop");
    return status.ok() ? ExpectEnd("facet") : status;
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

  /// The next word, on this line or a later one, in lower case; empty at the end of the file.
  std::string Next() {
    if (scanner_.AtLineEnd() && !scanner_.NextLine()) return "";
    return Lower(scanner_.Word());
  }

  Status Expect(const std::string& keyword) {
    const std::string word = Next();
    return word == keyword ? Status() : NotThe(keyword, word);
  }

  /// `endloop` or `end loop`.
  Status ExpectEnd(const std::string& keyword) {
    const std::string word = Next();
    return word == "end" ? Expect(keyword)
                         : (word == "end" + keyword ? Status() : NotThe("end" + keyword, word));
  }

  Status NotThe(const std::string& keyword, const std::string& word) const {
    if (word.empty()) return EndsEarly();
    return scanner_.Error(fmt::format("expected '{}', got {}", keyword, Quoted(word)));
  }

  Status NotAFacet(const std::string& word) const {
    return scanner_.Error(fmt::format("expected 'facet' or 'endsolid', got {}", Quoted(word)));
  }

  Status EndsEarly() const {
    return scanner_.Error("the file ends before 'endsolid'; is it cut off?");
  }

  TextScanner scanner_;
  std::vector<Eigen::Vector3d> corners_;
  std::string not_finite_at_;
};

/// Text, not a binary file whose first bytes are `solid`: those of its count or of its first normal
/// hold a 0.
bool IsText(std::string_view content) {
  const std::size_t first = content.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first != std::string_view::npos && Lower(content.substr(first, 5)) == "solid" &&
         content.substr(0, kHeader + kNormal).find('\0') == std::string_view::npos;
}

/// Whether what stands behind the announced triangles may be left alone: less than one of them, or
/// padding.
bool IsTail(std::string_view tail) {
  return tail.size() < kTriangle || tail.find_first_not_of('\0') == std::string_view::npos;
}

}  // namespace

bool IsBinaryStl(std::string_view content) {
  return content.size() >= kHeader && content.size() == AnnouncedSize(content);
}

StatusOr<PolygonSoup> ParseStl(const std::string& path, std::string_view content) {
  if (IsBinaryStl(content)) return ParseBinary(path, content);
  if (IsText(content)) return StlTextParser(path, content).Parse();
  if (content.size() < kHeader) {
    return Status::InvalidInput(fmt::format(
        "{}: neither text STL (it does not start with 'solid') nor binary (it is shorter than {} "
        "bytes); is it cut off?",
        path, kHeader));
  }
  const std::uint64_t announced = AnnouncedSize(content);
  if (announced > kHeader && announced < content.size() &&
      IsTail(content.substr(static_cast<std::size_t>(announced)))) {
    return ParseBinary(path, content);
  }
  return Status::InvalidInput(
      fmt::format("{}: a binary STL file with the count in its header has {} bytes, this one has "
                  "{}; is it cut off, or not STL?",
                  path, announced, content.size()));
}

}  // namespace cirque

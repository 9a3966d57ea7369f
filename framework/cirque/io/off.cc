#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/io/file_input.h"
#include "cirque/io/mesh_formats.h"
#include "cirque/io/text_writer.h"

namespace cirque {
namespace {

/// What the first word says: [ST][C][N][4][n]OFF and, where a blank was forgotten, the number of
/// vertices.
struct OffKeyword {
  bool is_off = false, has_texture = false, has_colour = false, has_normal = false;
  bool is_of_space = true;  ///< neither 4OFF nor nOFF
  std::string_view behind;  ///< of the word, what follows OFF
};

OffKeyword ReadKeyword(std::string_view word) {
  OffKeyword keyword;
  const auto skip = [&](std::string_view prefix) {
    const bool there = word.starts_with(prefix);
    if (there) word.remove_prefix(prefix.size());
    return there;
  };
  keyword.has_texture = skip("ST");
  keyword.has_colour = skip("C");
  keyword.has_normal = skip("N");
  const bool four = skip("4"), many = skip("n");
  keyword.is_of_space = !four && !many;
  keyword.is_off = skip("OFF");
  keyword.behind = word;
  return keyword;
}

/// The numbers of a file behind its keyword, as text or big-endian binary.
class OffNumbers {
 public:
  virtual ~OffNumbers() = default;
  virtual bool NextItem() = 0;  ///< goes to the next vertex or face; false at the end of the file
  virtual std::optional<long long> Integer() = 0;
  virtual std::optional<double> Real() = 0;
  virtual Status Expected(std::string_view what) = 0;  ///< after one of them had nothing
  virtual std::string Place() const = 0;
  /// The real numbers that are left of a vertex, `binary` of them where that is not told by the file.
  virtual void Rest(std::size_t binary, std::vector<double>* rest) = 0;
  /// Passes over what stands behind a face's corners (colours).
  virtual void SkipColours() = 0;
  /// Whether more follows than was read.
  virtual bool HasMore() = 0;
};

class OffText final : public OffNumbers {
 public:
  explicit OffText(TextScanner scanner) : scanner_(std::move(scanner)) {}

  bool NextItem() override { return scanner_.NextLine(); }
  std::optional<long long> Integer() override { return scanner_.Integer(); }
  std::optional<double> Real() override { return scanner_.Number(); }
  Status Expected(std::string_view what) override { return scanner_.Expected(what); }
  std::string Place() const override { return scanner_.Place(); }
  void Rest(std::size_t, std::vector<double>* rest) override {
    while (const std::optional<double> number = scanner_.Number()) rest->push_back(*number);
  }
  void SkipColours() override {}
  bool HasMore() override { return scanner_.NextLine(); }

 private:
  TextScanner scanner_;
};

class OffBytes final : public OffNumbers {
 public:
  OffBytes(std::string path, std::string_view bytes) : path_(std::move(path)), bytes_(bytes) {}

  bool NextItem() override { return !bytes_.empty(); }
  std::optional<long long> Integer() override { return Take<std::int32_t>(); }
  std::optional<double> Real() override { return Take<float>(); }
  Status Expected(std::string_view what) override {
    return Status::InvalidInput(
        fmt::format("{}: expected {}; is the file cut off, or not big-endian?", Place(), what));
  }
  std::string Place() const override {
    return fmt::format("{}: byte {} after the header", path_, at_);
  }
  void Rest(std::size_t binary, std::vector<double>* rest) override {
    for (std::size_t i = 0; i < binary; ++i) rest->push_back(Real().value_or(0));
  }
  void SkipColours() override {
    const long long count = Integer().value_or(0);
    for (long long i = 0; i < count && Real(); ++i) continue;
  }
  bool HasMore() override { return !bytes_.empty(); }

 private:
  template <class T>
  std::optional<T> Take() {
    if (bytes_.size() < sizeof(T)) {
      bytes_ = {};
      return std::nullopt;
    }
    const T value = ReadBytes<T>(bytes_, ByteOrder::kBig);
    bytes_.remove_prefix(sizeof(T));
    at_ += sizeof(T);
    return value;
  }

  std::string path_;
  std::string_view bytes_;
  std::size_t at_ = 0;
};

class OffParser {
 public:
  OffParser(const std::string& path, std::string_view text) : path_(path), scanner_(path, text) {}

  StatusOr<PolygonSoup> Parse() {
    Status status = ParseHeader();
    for (long long v = 0; status.ok() && v < num_vertices_; ++v) status = ParseVertex(v);
    for (long long f = 0; status.ok() && f < num_faces_; ++f) status = ParseFace(f);
    if (!status.ok()) return status;
    if (numbers_->HasMore()) more_.At(*numbers_);
    for (const PassedOver& kind : {few_corners_, more_, no_texture_}) kind.Warn(&soup_);
    KeepTexture();
    return std::move(soup_);
  }

 private:
  Status ParseHeader() {
    if (!scanner_.NextLine()) return scanner_.Error("the file is empty");
    TextScanner ahead = scanner_;
    keyword_ = ReadKeyword(ahead.Word());
    if (keyword_.is_off && !keyword_.is_of_space) {
      return scanner_.Error(
          "4OFF and nOFF hold points of other than three coordinates; project them to space");
    }
    if (keyword_.is_off) {
      scanner_ = ahead;
    } else if (ahead = scanner_; !ahead.Count() || !ahead.Count()) {
      return scanner_.Error(
          "expected the keyword OFF (or COFF, NOFF, STOFF); is this an OFF file?");
    } else {
      soup_.warnings.push_back(scanner_.Place() + ": the keyword OFF is missing");
    }
    if (ahead = scanner_; keyword_.is_off && ahead.Word() == "BINARY")
      return ParseBinaryCounts(ahead);
    return ParseCounts();
  }

  Status ParseCounts() {
    std::optional<long long> vertices;
    if (!keyword_.behind.empty() && keyword_.is_off) {
      vertices = TextScanner(path_, keyword_.behind).Count();
    } else {
      if (scanner_.AtLineEnd()) scanner_.NextLine();
      vertices = scanner_.Count();
    }
    const std::optional<long long> faces = vertices ? scanner_.Count() : std::nullopt;
    if (!faces) return scanner_.Expected("the numbers of vertices and faces");
    num_vertices_ = *vertices;
    num_faces_ = *faces;
    numbers_ = std::make_unique<OffText>(scanner_);
    return Status();
  }

  /// Three whole numbers: vertices, faces, edges.
  Status ParseBinaryCounts(TextScanner header) {
    numbers_ = std::make_unique<OffBytes>(path_, header.BytesAfterLine());
    is_binary_ = true;
    const std::optional<long long> vertices = numbers_->Integer(), faces = numbers_->Integer();
    if (!numbers_->Integer() || *vertices < 0 || *faces < 0) {
      return Status::InvalidInput(
          path_ +
          ": expected three big-endian integers of 32 bits behind 'OFF BINARY', the numbers of "
          "vertices, faces and edges; is the file cut off, or not big-endian?");
    }
    num_vertices_ = *vertices;
    num_faces_ = *faces;
    return Status();
  }

  Status ParseVertex(long long v) {
    if (!numbers_->NextItem()) return EndsEarly("vertex", v, num_vertices_);
    Eigen::Vector3d point;
    for (double& coordinate : point) {
      const std::optional<double> number = numbers_->Real();
      if (!number) return numbers_->Expected("three coordinates of a vertex");
      coordinate = *number;
    }
    soup_.position.push_back(point);
    if (!point.allFinite() && soup_.not_finite_at.empty()) soup_.not_finite_at = numbers_->Place();
    if (keyword_.has_texture || is_binary_) ParseRestOfVertex();
    return Status();
  }

  /// Normal (3), colour (as text 3 or 4, binary 4) and, last, texture coordinates (2).
  void ParseRestOfVertex() {
    rest_.clear();
    numbers_->Rest((keyword_.has_normal ? 3 : 0) + (keyword_.has_colour ? 4 : 0) +
                       (keyword_.has_texture ? 2 : 0),
                   &rest_);
    if (!keyword_.has_texture) return;
    if (rest_.size() < 2) {
      no_texture_.At(*numbers_);
      lacks_texture_ = true;
    } else {
      soup_.texture.emplace_back(rest_[rest_.size() - 2], rest_[rest_.size() - 1]);
    }
  }

  Status ParseFace(long long f) {
    if (!numbers_->NextItem()) return EndsEarly("face", f, num_faces_);
    const std::optional<long long> size = numbers_->Integer();
    if (!size) return numbers_->Expected("the number of corners of a face");
    if (*size < 0) return Error(fmt::format("a face of {} corners; the file is damaged", *size));
    corners_.clear();
    for (long long c = 0; c < *size; ++c) {
      const std::optional<long long> vertex = numbers_->Integer();
      if (!vertex) {
        return numbers_->Expected(fmt::format("{} vertex indices, as the line says", *size));
      }
      corners_.push_back(*vertex);
    }
    numbers_->SkipColours();
    if (*size < 3) {
      few_corners_.At(*numbers_);
      return Status();
    }
    const std::string problem = AddPolygon(corners_, &soup_);
    return problem.empty() ? Status() : Error(problem);
  }

  void KeepTexture() {
    if (lacks_texture_) soup_.texture.clear();
    if (!soup_.texture.empty()) soup_.corner_texture = soup_.corner;
  }

  Status EndsEarly(const char* kind, long long found, long long promised) const {
    return Error(
        fmt::format("the file ends after {} {} of {}; is it cut off?", kind, found, promised));
  }

  Status Error(const std::string& message) const {
    return Status::InvalidInput(numbers_->Place() + ": " + message);
  }

  const std::string& path_;
  TextScanner scanner_;
  OffKeyword keyword_;
  bool is_binary_ = false, lacks_texture_ = false;
  std::unique_ptr<OffNumbers> numbers_;
  long long num_vertices_ = 0, num_faces_ = 0;
  PolygonSoup soup_;
  std::vector<std::int64_t> corners_;
  std::vector<double> rest_;
  PassedOver few_corners_{kTooFewCorners};
  PassedOver more_{"more follows than the header promises, and is ignored"};
  PassedOver no_texture_{
      "a vertex without the texture coordinates that the keyword promises: all of them are "
      "ignored"};
};

}  // namespace

StatusOr<PolygonSoup> ParseOff(const std::string& path, std::string_view text) {
  return OffParser(path, text).Parse();
}

TextPieces FormatOff(const PolygonSoup& mesh) {
  SplitVertices split;
  const bool textured = !mesh.texture.empty();
  if (textured) split = SplitAtSeams(mesh);
  TextWriter out;
  out.Text(textured ? "STOFF\n" : "OFF\n");
  out.Number(textured ? split.vertex.size() : mesh.position.size());
  out.Text(" ");
  out.Number(mesh.num_polygons());
  out.Text(" 0\n");
  WritePointsAndPolygons(mesh, textured ? &split : nullptr, &out);
  return std::move(out).TakePieces();
}

}  // namespace cirque

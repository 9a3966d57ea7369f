#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/io/file_input.h"
#include "cirque/io/mesh_formats.h"

namespace cirque {
namespace {

constexpr std::size_t kHeader = 16;       ///< bytes: "OM", kind, version, three counts
constexpr std::size_t kLargestFloat = 8;  ///< bytes

enum Entity { kVertex = 0, kMesh = 1, kFace = 2, kEdge = 4, kHalfedge = 6, kSentinel = 7 };
enum Type { kPosition = 0, kStatus = 3, kColour = 4, kCustom = 6, kTopology = 7 };

/// What stands before a chunk, 16 bits from the least on: 1 unused, 1 named, 3 entity, 4 type,
/// 1 signed, 1 float, 3 dimension less 1, 2 the logarithm of the size.
struct ChunkHeader {
  explicit ChunkHeader(std::uint16_t bits)
      : is_named((bits >> 1 & 1) != 0),
        entity(bits >> 2 & 7),
        type(bits >> 5 & 15),
        is_float((bits >> 10 & 1) != 0),
        dimension((bits >> 11 & 7) + 1),
        log_size(bits >> 14 & 3) {}

  bool is_named;
  int entity, type;
  bool is_float;
  std::size_t dimension, log_size;

  /// Bytes of one number: integers are those of topology, whatever its flag says, and of colours.
  std::size_t NumberSize() const {
    const bool is_integer = type == kTopology || (type == kColour && !is_float);
    return (is_integer ? std::size_t{1} : std::size_t{4}) << log_size;
  }
};

/// Number i of whole little-endian ones of `size` bytes.
std::uint64_t Unsigned(std::string_view bytes, std::size_t i, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t k = size; k-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes[i * size + k]);
  }
  return value;
}

/// Signed ones, one after another.
class Integers {
 public:
  Integers(std::string_view bytes, std::size_t size) : bytes_(bytes), size_(size) {}

  /// Number i, -1 where it is negative.
  std::int64_t operator[](std::size_t i) const {
    const std::uint64_t value = Unsigned(bytes_, i, size_);
    return value >> (8 * size_ - 1) != 0 ? -1 : static_cast<std::int64_t>(value);
  }

  bool empty() const { return bytes_.empty(); }

 private:
  std::string_view bytes_;
  std::size_t size_;
};

class OmParser {
 public:
  OmParser(const std::string& path, std::string_view content) : path_(path), content_(content) {}

  StatusOr<PolygonSoup> Parse() {
    if (Status s = ParseHeader(); !s.ok()) return s;
    while (!ended_ && at_ < content_.size()) {
      if (Status s = ParseChunk(); !s.ok()) return s;
    }
    if (!ended_) {
      soup_.warnings.push_back(path_ + ": the chunk that ends the file is missing; is it cut off?");
    }
    if (num_vertices_ > 0 && soup_.position.empty()) return Error("the file has no positions");
    if (num_faces_ > 0 && !has_faces_) {
      return Error(fmt::format("the file ends before its {} faces; is it cut off?", num_faces_));
    }
    if (Status s = is_old_ ? Status() : WalkFaces(); !s.ok()) return s;
    few_corners_.Warn(&soup_);
    return std::move(soup_);
  }

  std::string Place() const { return fmt::format("{}: byte {}", path_, at_); }

 private:
  Status ParseHeader() {
    if (content_.size() < kHeader || !content_.starts_with("OM")) {
      return Error("expected the 16 bytes of an OM header; is the file cut off?");
    }
    kind_ = content_[2];
    version_ = static_cast<unsigned char>(content_[3]);
    const int major = version_ >> 5;
    if ((kind_ != 'T' && kind_ != 'Q' && kind_ != 'P') || major < 1 || major > 2) {
      return Error(
          fmt::format("expected OM of triangles, quadrilaterals or polygons, version 1 or "
                      "2; got {} of version {}.{}",
                      Quoted(content_.substr(2, 1)), major, version_ & 31));
    }
    is_old_ = major == 1;
    num_vertices_ = Take32(4);
    num_faces_ = Take32(8);
    num_edges_ = Take32(12);
    at_ = kHeader;
    return Status();
  }

  std::size_t Take32(std::size_t at) const {
    return ReadBytes<std::uint32_t>(content_.substr(at), ByteOrder::kLittle);
  }

  std::size_t Left() const { return content_.size() - at_; }

  /// The number of elements that a chunk is about.
  std::optional<std::size_t> CountOf(int entity) const {
    switch (entity) {
      case kVertex:
        return num_vertices_;
      case kMesh:
        return 1;
      case kFace:
        return num_faces_;
      case kEdge:
        return num_edges_;
      case kHalfedge:
        return 2 * num_edges_;
      default:
        return std::nullopt;
    }
  }

  Status ParseChunk() {
    if (Left() < 2) return EndsEarly("a chunk's header");
    const ChunkHeader chunk(ReadBytes<std::uint16_t>(content_.substr(at_), ByteOrder::kLittle));
    at_ += 2;
    ended_ = chunk.entity == kSentinel;
    if (ended_) return Status();
    const auto count = CountOf(chunk.entity);
    if (!count) return Error("a chunk of no kind of element; the file is damaged");
    if (chunk.is_named || chunk.type == kCustom) return SkipProperty(chunk);
    if (is_old_ && chunk.entity == kFace && chunk.type == kTopology) return ParseOldFaces(chunk);
    const std::size_t element = chunk.dimension * chunk.NumberSize();
    if (*count > Left() / element) return EndsEarly(fmt::format("{} elements", *count));
    const std::string_view data = content_.substr(at_, *count * element);
    Status status = TakeChunk(chunk, data);
    at_ += data.size();
    return status;
  }

  Status TakeChunk(const ChunkHeader& chunk, std::string_view data) {
    const bool of_vertices = chunk.entity == kVertex;
    if (of_vertices && chunk.type == kPosition) return TakePositions(chunk, data);
    if (chunk.entity == kFace && chunk.type == kStatus) {
      for (std::size_t f = 0; f < num_faces_; ++f) {
        is_deleted_.push_back((data[f * chunk.dimension * chunk.NumberSize()] & 1) != 0);
      }
    }
    if (chunk.type != kTopology) return Status();
    const Integers numbers(data, chunk.NumberSize());
    const std::size_t expected = chunk.entity == kHalfedge ? 3 : 1;
    if (chunk.dimension != expected) return Error("connectivity of another shape than OpenMesh's");
    if (chunk.entity == kHalfedge) halfedge_ = numbers;
    if (chunk.entity == kFace) face_halfedge_ = numbers;
    has_faces_ = has_faces_ || chunk.entity == kFace;
    return Status();
  }

  Status TakePositions(const ChunkHeader& chunk, std::string_view data) {
    const std::size_t size = chunk.NumberSize();
    if (!chunk.is_float || size > kLargestFloat || chunk.dimension != 3) {
      return Error("expected positions of three floats or doubles");
    }
    if (!soup_.position.empty()) return Error("positions twice; the file is damaged");
    soup_.position.resize(num_vertices_);
    for (std::size_t v = 0; v < num_vertices_; ++v) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::string_view bytes = data.substr((3 * v + i) * size);
        soup_.position[v][static_cast<int>(i)] =
            size == sizeof(float) ? static_cast<double>(ReadBytes<float>(bytes, ByteOrder::kLittle))
                                  : ReadBytes<double>(bytes, ByteOrder::kLittle);
      }
      if (!soup_.position[v].allFinite() && soup_.not_finite_at.empty()) {
        soup_.not_finite_at = fmt::format("{}: byte {}", path_, at_ + 3 * v * size);
      }
    }
    return Status();
  }

  /// A name (a byte its length), since 2.2 that of its type, a size of 32 bits and so many bytes.
  Status SkipProperty(const ChunkHeader& chunk) {
    constexpr int kWithType = 2 << 5 | 2;
    const int names = (chunk.is_named ? 1 : 0) + (version_ >= kWithType ? 1 : 0);
    for (int i = 0; i < names; ++i) {
      if (Left() < 1) return EndsEarly("a property's name");
      const std::size_t length = 1 + std::size_t{static_cast<unsigned char>(content_[at_])};
      if (Left() < length) return EndsEarly("a property's name");
      at_ += length;
    }
    if (Left() < 4 || Left() - 4 < Take32(at_)) return EndsEarly("a property");
    at_ += 4 + Take32(at_);
    return Status();
  }

  /// Until version 2 faces are lists of vertices, those of polygons behind their number in 16 bits.
  Status ParseOldFaces(const ChunkHeader& chunk) {
    const std::size_t size = chunk.NumberSize();
    has_faces_ = true;
    std::vector<std::int64_t> corners;
    for (std::size_t f = 0; f < num_faces_; ++f) {
      std::size_t count = kind_ == 'T' ? 3 : 4;
      if (kind_ == 'P') {
        if (Left() < 2) return EndsEarly(fmt::format("{} faces", num_faces_));
        count = ReadBytes<std::uint16_t>(content_.substr(at_), ByteOrder::kLittle);
        at_ += 2;
      }
      if (Left() / size < count) return EndsEarly(fmt::format("{} faces", num_faces_));
      const std::string_view data = content_.substr(at_, count * size);
      corners.clear();
      for (std::size_t i = 0; i < count; ++i) {
        corners.push_back(static_cast<std::int64_t>(Unsigned(data, i, size)));
      }
      if (Status s = Add(corners); !s.ok()) return s;
      at_ += data.size();
    }
    return Status();
  }

  /// Around every face that is not deleted, from the halfedge it names on.
  Status WalkFaces() {
    if (num_faces_ == 0) return Status();
    if (halfedge_.empty()) return Error("the file has no halfedges");
    std::vector<bool> used(2 * num_edges_, false);
    std::vector<std::int64_t> corners;
    for (std::size_t f = 0; f < num_faces_; ++f) {
      if (!is_deleted_.empty() && is_deleted_[f]) continue;
      corners.clear();
      const std::int64_t first = face_halfedge_[f];
      for (std::int64_t h = first; corners.empty() || h != first;) {
        const auto at = static_cast<std::size_t>(h);
        if (h < 0 || at >= used.size() || used[at]) {
          return Error(
              fmt::format("the halfedges of face {} (counted from 1) do not close; the "
                          "file is damaged",
                          f + 1));
        }
        used[at] = true;
        corners.push_back(halfedge_[3 * at + 1]);
        h = halfedge_[3 * at];
      }
      if (Status s = Add(corners); !s.ok()) return s;
    }
    return Status();
  }

  Status Add(const std::vector<std::int64_t>& corners) {
    if (corners.size() < 3) {
      few_corners_.At(*this);
      return Status();
    }
    const std::string problem = AddPolygon(corners, &soup_);
    return problem.empty() ? Status() : Error(problem);
  }

  Status EndsEarly(const std::string& what) const {
    return Error(fmt::format("the file ends within {}; is it cut off?", what));
  }

  Status Error(const std::string& message) const {
    return Status::InvalidInput(Place() + ": " + message);
  }

  const std::string& path_;
  std::string_view content_;
  std::size_t at_ = 0;
  char kind_ = 'P';
  int version_ = 0;
  bool is_old_ = false, ended_ = false, has_faces_ = false;
  std::size_t num_vertices_ = 0, num_faces_ = 0, num_edges_ = 0;
  /// Of every halfedge the next one, its vertex and its face; of every face a halfedge.
  Integers halfedge_{{}, 1}, face_halfedge_{{}, 1};
  std::vector<bool> is_deleted_;  ///< per face; empty: none is
  PassedOver few_corners_{kTooFewCorners};
  PolygonSoup soup_;
};

}  // namespace

bool IsOm(std::string_view content) {
  if (content.size() < kHeader || !content.starts_with("OM")) return false;
  const int major = static_cast<unsigned char>(content[3]) >> 5;
  return std::string_view("TQP").find(content[2]) != std::string_view::npos &&
         (major == 1 || major == 2);
}

StatusOr<PolygonSoup> ParseOm(const std::string& path, std::string_view content) {
  return OmParser(path, content).Parse();
}

}  // namespace cirque

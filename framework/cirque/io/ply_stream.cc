#include "cirque/io/ply_stream.h"

#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/registry.h"
#include "cirque/io/file_input.h"

namespace cirque {
namespace {

/// Both generations of type names.
const Registry<PlyType>& Types() {
  static const Registry<PlyType> types("PLY type", {{"char", PlyType::kInt8},
                                                    {"uchar", PlyType::kUint8},
                                                    {"short", PlyType::kInt16},
                                                    {"ushort", PlyType::kUint16},
                                                    {"int", PlyType::kInt32},
                                                    {"uint", PlyType::kUint32},
                                                    {"float", PlyType::kFloat32},
                                                    {"double", PlyType::kFloat64},
                                                    {"int8", PlyType::kInt8},
                                                    {"uint8", PlyType::kUint8},
                                                    {"int16", PlyType::kInt16},
                                                    {"uint16", PlyType::kUint16},
                                                    {"int32", PlyType::kInt32},
                                                    {"uint32", PlyType::kUint32},
                                                    {"float32", PlyType::kFloat32},
                                                    {"float64", PlyType::kFloat64}});
  return types;
}

const Registry<PlyEncoding>& Encodings() {
  static const Registry<PlyEncoding> encodings(
      "PLY format", {{"ascii", PlyEncoding::kText},
                     {"binary_little_endian", PlyEncoding::kLittleEndian},
                     {"binary_big_endian", PlyEncoding::kBigEndian}});
  return encodings;
}

/// Looks the next word up in the table.
template <class T>
Status ParseName(const Registry<T>& table, TextScanner* scanner, T* value) {
  const std::string_view word = scanner->Word();
  const StatusOr<T> found = table.Find(Printable(word));
  if (!found.ok()) return scanner->Error(found.status().message());
  *value = *found;
  return Status();
}

Status ParseElement(TextScanner* scanner, PlyHeader* header) {
  PlyElement& element = header->elements.emplace_back();
  element.name = scanner->Word();
  const std::optional<long long> count = scanner->Count();
  if (!count) return scanner->Expected("'element NAME COUNT'");
  element.count = *count;
  return Status();
}

Status ParseProperty(TextScanner* scanner, PlyHeader* header) {
  if (header->elements.empty()) return scanner->Error("expected an element before its properties");
  PlyProperty& property = header->elements.back().properties.emplace_back();
  TextScanner ahead = *scanner;
  property.is_list = ahead.Word() == "list";
  Status status;
  if (property.is_list) {
    *scanner = ahead;
    status = ParseName(Types(), scanner, &property.count_type);
  }
  if (status.ok()) status = ParseName(Types(), scanner, &property.type);
  property.name = scanner->Word();
  return status;
}

}  // namespace

StatusOr<PlyHeader> ParsePlyHeader(TextScanner* scanner) {
  if (!scanner->NextLine() || scanner->Word() != "ply") {
    return scanner->Error("expected 'ply' on the first line; is this a PLY file?");
  }
  PlyHeader header;
  bool has_format = false;
  while (scanner->NextLine()) {
    const std::string_view keyword = scanner->Word();
    Status status;
    if (keyword == "format") {
      status = ParseName(Encodings(), scanner, &header.encoding);
      has_format = true;
    } else if (keyword == "element") {
      status = ParseElement(scanner, &header);
    } else if (keyword == "property") {
      status = ParseProperty(scanner, &header);
    } else if (keyword == "end_header") {
      return has_format ? StatusOr<PlyHeader>(std::move(header))
                        : scanner->Error("expected a 'format' line in the header");
    } else if (keyword != "comment" && keyword != "obj_info") {
      header.warnings.push_back(
          fmt::format("{}: a line of the header that begins with {} is ignored", scanner->Place(),
                      Quoted(keyword)));
    }
    if (!status.ok()) return status;
  }
  return scanner->Error("the file ends before 'end_header'; is it cut off?");
}

namespace {

class TextBody final : public PlyBody {
 public:
  explicit TextBody(TextScanner scanner) : scanner_(std::move(scanner)) {}

  bool NextElement() override { return scanner_.NextLine(); }
  std::optional<double> Number(PlyType) override { return scanner_.Number(); }
  Status Missing(std::string_view what) override { return scanner_.Expected(what); }
  std::string Place() const override { return scanner_.Place(); }

 private:
  TextScanner scanner_;
};

class BinaryBody final : public PlyBody {
 public:
  BinaryBody(std::string path, std::string_view bytes, ByteOrder order)
      : path_(std::move(path)), bytes_(bytes), order_(order) {}

  bool NextElement() override { return at_ < bytes_.size(); }

  std::optional<double> Number(PlyType type) override {
    switch (type) {
      case PlyType::kInt8:
        return Take<std::int8_t>();
      case PlyType::kUint8:
        return Take<std::uint8_t>();
      case PlyType::kInt16:
        return Take<std::int16_t>();
      case PlyType::kUint16:
        return Take<std::uint16_t>();
      case PlyType::kInt32:
        return Take<std::int32_t>();
      case PlyType::kUint32:
        return Take<std::uint32_t>();
      case PlyType::kFloat32:
        return Take<float>();
      case PlyType::kFloat64:
        return Take<double>();
    }
    return std::nullopt;
  }

  Status Missing(std::string_view what) override {
    return Error(fmt::format("expected {}, got the end of the file; is it cut off?", what));
  }

  std::string Place() const override {
    return fmt::format("{}: byte {} after the header", path_, at_);
  }

 private:
  template <class T>
  std::optional<double> Take() {
    if (bytes_.size() - at_ < sizeof(T)) return std::nullopt;
    const T value = ReadBytes<T>(bytes_.substr(at_), order_);
    at_ += sizeof(T);
    return static_cast<double>(value);
  }

  std::string path_;
  std::string_view bytes_;
  ByteOrder order_;
  std::size_t at_ = 0;
};

}  // namespace

Status PlyBody::Error(std::string_view message) const {
  return Status::InvalidInput(fmt::format("{}: {}", Place(), message));
}

std::unique_ptr<PlyBody> MakePlyBody(PlyEncoding encoding, const std::string& path,
                                     TextScanner scanner) {
  if (encoding == PlyEncoding::kText) return std::make_unique<TextBody>(std::move(scanner));
  const ByteOrder order =
      encoding == PlyEncoding::kLittleEndian ? ByteOrder::kLittle : ByteOrder::kBig;
  return std::make_unique<BinaryBody>(path, scanner.BytesAfterLine(), order);
}

}  // namespace cirque

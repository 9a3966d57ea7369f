#include "cirque/io/ply_header.h"

#include <utility>

#include "cirque/core/registry.h"

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
      status = scanner->Error("expected format, element, property, comment or end_header, got " +
                              Quoted(keyword));
    }
    if (!status.ok()) return status;
  }
  return scanner->Error("the file ends before 'end_header'; is it cut off?");
}

}  // namespace cirque

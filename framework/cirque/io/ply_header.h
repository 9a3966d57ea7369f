#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/io/text_scanner.h"

namespace cirque {

enum class PlyEncoding { kText, kLittleEndian, kBigEndian };
enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kInt8;
  bool is_list = false;
  PlyType count_type = PlyType::kInt8;  ///< of a list's length
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kText;
  std::vector<PlyElement> elements;
};

/// Reads the header; the scanner is left on the line `end_header`.
StatusOr<PlyHeader> ParsePlyHeader(TextScanner* scanner);

}  // namespace cirque

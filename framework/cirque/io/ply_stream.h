#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/io/file_input.h"

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
  std::vector<std::string> warnings;  ///< "path:line: ..." of lines that are none of a header
};

/// Reads the header; the scanner is left on the line `end_header`.
StatusOr<PlyHeader> ParsePlyHeader(TextScanner* scanner);

/// The numbers after a PLY header, one after the other, whatever their encoding.
class PlyBody {
 public:
  virtual ~PlyBody() = default;

  /// Goes to the next element (in text: the next line). False at the end of the file.
  virtual bool NextElement() = 0;

  /// The next number of the element; nothing where the file or line ends or holds no number.
  virtual std::optional<double> Number(PlyType type) = 0;

  /// Why Number() had nothing, when it was asked for `what`.
  virtual Status Missing(std::string_view what) = 0;

  /// "path:line", "path: byte N after the header".
  virtual std::string Place() const = 0;

  /// "PLACE: MESSAGE".
  Status Error(std::string_view message) const;
};

/// The body behind the header that the scanner has just read. `path` serves the messages; the
/// scanner's text must outlive the body.
std::unique_ptr<PlyBody> MakePlyBody(PlyEncoding encoding, const std::string& path,
                                     TextScanner scanner);

}  // namespace cirque

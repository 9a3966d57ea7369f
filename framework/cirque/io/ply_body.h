#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "cirque/io/ply_header.h"

namespace cirque {

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

  /// "path:line: MESSAGE", "path: byte N: MESSAGE".
  virtual Status Error(std::string_view message) const = 0;
};

/// The body behind the header that the scanner has just read. `path` serves the messages; the
/// scanner's text must outlive the body.
std::unique_ptr<PlyBody> MakePlyBody(PlyEncoding encoding, const std::string& path,
                                     TextScanner scanner);

}  // namespace cirque

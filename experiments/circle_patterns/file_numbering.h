#pragma once

#include <string>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// Vertices of a surface by the numbers, counted from 1, that they have in their mesh file.
class FileNumbering {
 public:
  /// `count`: of the vertices in the file, isolated ones included.
  FileNumbering(const Surface& surface, Index count);

  /// "3,17,4", or a single vertex. `flag` names it in messages.
  StatusOr<std::vector<Index>> Read(const std::string& flag, const std::string& text) const;

 private:
  StatusOr<Index> ReadOne(const std::string& flag, const std::string& text) const;

  std::vector<Index> of_file_;
};

}  // namespace cirque

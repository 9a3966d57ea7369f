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

  /// One vertex; kNone stays where the text is empty. `flag` names it in messages.
  Status Read(const char* flag, const std::string& text, Index* vertex) const;

  /// "3,17,4".
  Status ReadList(const char* flag, const std::string& text, std::vector<Index>* vertices) const;

 private:
  std::vector<Index> of_file_;
};

}  // namespace cirque

#pragma once

#include <charconv>
#include <string>
#include <string_view>
#include <utility>

#include "cirque/mesh/polygon_soup.h"

namespace cirque {

/// Text in one growing buffer, numbers in the fewest digits that read back to the same bits.
class TextWriter {
 public:
  void Text(std::string_view text) { text_ += text; }

  template <class T>
  void Number(T value) {
    char digits[32];
    text_.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
  }

  /// The coordinates of a point, a blank between them, and the end of the line.
  template <class Point>
  void PointLine(const Point& point) {
    for (Eigen::Index i = 0; i < point.size(); ++i) {
      if (i > 0) text_ += ' ';
      Number(point[i]);
    }
    text_ += '\n';
  }

  std::string Take() && { return std::move(text_); }

 private:
  std::string text_;
};

/// The body that OFF and PLY share: a line of coordinates a vertex, then a line a polygon, its
/// number of corners and their vertices counted from 0.
void WritePointsAndPolygons(const PolygonSoup& mesh, TextWriter* out);

}  // namespace cirque

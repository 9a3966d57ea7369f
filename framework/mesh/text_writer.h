#pragma once

#include <charconv>
#include <string>
#include <string_view>

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

  /// The numbers of a point, a blank before each.
  template <class Point>
  void Coordinates(const Point& point) {
    for (const double coordinate : point) {
      text_ += ' ';
      Number(coordinate);
    }
  }

  std::string Take() && { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace cirque

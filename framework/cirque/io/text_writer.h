#pragma once

#include <charconv>
#include <string>
#include <string_view>
#include <utility>

#include <Eigen/Core>

#include "cirque/core/atomic_file.h"
#include "cirque/core/parallel.h"

namespace cirque {

/// Text in growing buffers, numbers in the fewest digits that read back to the same bits.
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

  /// What write(i, out) writes for every i in [0, n), on all cores.
  template <class Write>
  void Lines(int n, const Write& write) {
    EndPiece();
    const std::size_t first = pieces_.size();
    pieces_.resize(first + NumBlocks(n));
    ForEachBlock(n, [&](int block, int begin, int end) {
      TextWriter out;
      for (int i = begin; i < end; ++i) write(i, &out);
      pieces_[first + block] = std::move(out).Take();
    });
  }

  /// All of it, of which Lines() wrote nothing.
  std::string Take() && { return std::move(text_); }

  /// All of it, in pieces one after another.
  TextPieces TakePieces() && {
    EndPiece();
    return std::move(pieces_);
  }

 private:
  void EndPiece() {
    if (!text_.empty()) pieces_.push_back(std::move(text_));
    text_.clear();
  }

  TextPieces pieces_;
  std::string text_;
};

}  // namespace cirque

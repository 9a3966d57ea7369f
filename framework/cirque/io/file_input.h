#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "cirque/core/status.h"

namespace cirque {

/// The bytes of a file (or pipe), by one read into one buffer. Not mapped: a file that shrinks
/// while it is read would end the process. Errors name the path and the system's reason.
StatusOr<std::string> ReadFileContent(const std::string& path);

enum class ByteOrder { kLittle, kBig };

/// The number of type T in the first sizeof(T) bytes; there must be as many.
template <class T>
T ReadBytes(std::string_view bytes, ByteOrder order) {
  char raw[sizeof(T)];
  std::copy_n(bytes.data(), sizeof(T), raw);
  if ((order == ByteOrder::kLittle) != (std::endian::native == std::endian::little)) {
    std::reverse(raw, raw + sizeof(T));
  }
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

/// Walks through the text of a mesh file line by line and word by word, and knows the line it is
/// on, so that every error can start with "path:line: ". Words are separated by blanks; '#' starts
/// a comment (but not in 1.#IND, see Number); lines end with LF, CRLF or CR. The text must outlive
/// the scanner.
class TextScanner {
 public:
  enum class Continuation { kNever, kBackslash };
  /// What a byte order mark (of UTF-8) at the beginning of the text is: a file begins with one that
  /// says nothing, a stretch from the middle of a file with one that belongs to a word.
  enum class Mark { kIsSkipped, kIsText };

  /// With kBackslash a backslash at the end of a line joins the next line to it (OBJ).
  TextScanner(std::string path, std::string_view text,
              Continuation continuation = Continuation::kNever, Mark mark = Mark::kIsSkipped);

  /// Leaves the rest of the current line and goes to the next one that holds a word. False at the
  /// end of the text.
  bool NextLine();

  /// The next word of the line, empty at the line's end.
  std::string_view Word();

  /// Whether no word is left on the line.
  bool AtLineEnd();

  /// The next word as a number ("nan" and "inf" are numbers, and so are 1.#IND, 1.#INF and the like,
  /// which older programs for Windows write). When it is none, the scanner stays in front of it.
  std::optional<double> Number();

  /// The next word as a whole number that fits 64 bits, as above.
  std::optional<long long> Integer();

  /// The same, at least 0.
  std::optional<long long> Count();

  /// "path:line: expected EXPECTED, got 'WORD'", where the word is the one in front of the scanner.
  Status Expected(std::string_view expected);

  /// "path:line: MESSAGE".
  Status Error(std::string_view message) const;

  /// "path:line".
  std::string Place() const;

  int line() const { return line_; }
  /// What follows the current line, as raw bytes (the body of a binary PLY file); NextLine goes on
  /// there.
  std::string_view BytesAfterLine();

 private:
  bool AtNewline(const char* c) const;
  void SkipBlanks();
  void SkipLine();
  const char* EndOfNewline(const char* c) const;
  const char* EndOfContinuation(const char* c) const;
  bool EndsWord(const char* c) const;
  std::string_view Rest() const;

  std::string path_;
  const char* position_;
  const char* end_;
  Continuation continuation_;
  int line_ = 1;
  bool started_ = false;
};

/// The word, shortened, with unprintable bytes as '?': fit for a message.
std::string Printable(std::string_view word);

/// The same in quotes.
std::string Quoted(std::string_view word);

}  // namespace cirque

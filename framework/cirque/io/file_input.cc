#include "cirque/io/file_input.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <utility>

#include <fmt/format.h>

namespace cirque {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

Status Failure(const std::string& path) {
  return Status::InvalidInput(fmt::format("{}: cannot read: {}", path, std::strerror(errno)));
}

/// What the system expects a read to return; a pipe says 0.
std::size_t ExpectedSize(std::FILE* file) {
  struct stat information = {};
  const bool known = fstat(fileno(file), &information) == 0 && S_ISREG(information.st_mode);
  return known ? static_cast<std::size_t>(information.st_size) : 0;
}

}  // namespace

StatusOr<std::string> ReadFileContent(const std::string& path) {
  std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file) return Failure(path);
  std::string content;
  std::size_t size = 0;
  // One byte more than expected, so that the read that fills a regular file also sees its end.
  for (std::size_t room = ExpectedSize(file.get()) + 1;;
       room = std::max(size, std::size_t{65536})) {
    content.resize(size + room);
    const std::size_t got = std::fread(content.data() + size, 1, room, file.get());
    size += got;
    if (got < room) break;
  }
  if (std::ferror(file.get()) != 0) return Failure(path);
  content.resize(size);
  return content;
}

namespace {

bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

/// from_chars knows no leading plus sign; printf("%+g") writes one.
const char* SkipPlus(const char* first, const char* last) {
  return last - first > 1 && first[0] == '+' && first[1] != '-' ? first + 1 : first;
}

constexpr std::string_view kMicrosoftMark = "1.#";

/// What Microsoft's printf wrote until 2015 for numbers that are not finite, where `text` begins with
/// one: 1.#INF, -1.#IND00, 1.#QNAN, cut and rounded as 1.#R; else empty.
std::string_view MicrosoftWord(std::string_view text) {
  const auto is_in_it = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
  std::size_t end = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  if (!text.substr(end).starts_with(kMicrosoftMark)) return {};
  end += kMicrosoftMark.size();
  if (end == text.size() || text[end] < 'A' || text[end] > 'Z') return {};
  while (end < text.size() && is_in_it(text[end])) ++end;
  return text.substr(0, end);
}

double MicrosoftValue(std::string_view word) {
  const bool infinite = word.find("#INF") != std::string_view::npos;
  const double value =
      infinite ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
  return word.starts_with('-') ? -value : value;
}

}  // namespace

TextScanner::TextScanner(std::string path, std::string_view text, Continuation continuation,
                         Mark mark)
    : path_(std::move(path)),
      position_(text.data()),
      end_(text.data() + text.size()),
      continuation_(continuation) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (mark == Mark::kIsSkipped && text.starts_with(kByteOrderMark)) {
    position_ += kByteOrderMark.size();
  }
}

bool TextScanner::AtNewline(const char* c) const {
  return *c == '\n' || (*c == '\r' && (c + 1 == end_ || c[1] != '\n'));
}

const char* TextScanner::EndOfNewline(const char* c) const {
  return *c == '\r' && c + 1 != end_ && c[1] == '\n' ? c + 2 : c + 1;
}

/// Behind the backslash and newline at c, or c itself where there are none.
const char* TextScanner::EndOfContinuation(const char* c) const {
  if (continuation_ == Continuation::kNever || *c != '\\' || c + 1 == end_) return c;
  return c[1] == '\n' || c[1] == '\r' ? EndOfNewline(c + 1) : c;
}

bool TextScanner::EndsWord(const char* c) const {
  return c == end_ || IsBlank(*c) || *c == '\n' || *c == '\r' || *c == '#' ||
         EndOfContinuation(c) != c;
}

void TextScanner::SkipBlanks() {
  while (position_ != end_) {
    if (IsBlank(*position_) || (*position_ == '\r' && !AtNewline(position_))) {
      ++position_;
    } else if (const char* next = EndOfContinuation(position_); next != position_) {
      position_ = next;
      ++line_;
    } else if (*position_ == '#') {
      while (position_ != end_ && !AtNewline(position_)) ++position_;
    } else {
      return;
    }
  }
}

bool TextScanner::AtLineEnd() {
  SkipBlanks();
  return position_ == end_ || AtNewline(position_);
}

void TextScanner::SkipLine() {
  while (!AtLineEnd()) Word();
  if (position_ == end_) return;
  position_ = EndOfNewline(position_);
  ++line_;
}

bool TextScanner::NextLine() {
  if (started_) SkipLine();
  started_ = true;
  while (position_ != end_ && AtLineEnd()) SkipLine();
  return position_ != end_;
}

std::string_view TextScanner::Rest() const {
  return {position_, static_cast<std::size_t>(end_ - position_)};
}

std::string_view TextScanner::Word() {
  if (AtLineEnd()) return {};
  const char* first = position_;
  position_ += MicrosoftWord(Rest()).size();
  while (!EndsWord(position_)) ++position_;
  return {first, static_cast<std::size_t>(position_ - first)};
}

std::optional<double> TextScanner::Number() {
  SkipBlanks();
  const char* first = SkipPlus(position_, end_);
  double value = 0;
  const auto [last, error] = std::from_chars(first, end_, value);
  if (error == std::errc::invalid_argument || !EndsWord(last)) return std::nullopt;
  if (last != end_ && *last == '#') {
    const std::string_view word = MicrosoftWord(Rest());
    if (!word.empty()) {
      position_ += word.size();
      return MicrosoftValue(word);
    }
  }
  // Beyond the range of doubles: strtod gives the 0 or infinity that the digits round to.
  if (error != std::errc()) value = std::strtod(std::string(first, last).c_str(), nullptr);
  position_ = last;
  return value;
}

std::optional<long long> TextScanner::Integer() {
  SkipBlanks();
  long long value = 0;
  const auto [last, error] = std::from_chars(SkipPlus(position_, end_), end_, value);
  if (error != std::errc() || !EndsWord(last)) return std::nullopt;
  position_ = last;
  return value;
}

std::optional<long long> TextScanner::Count() {
  return !AtLineEnd() && *position_ == '-' ? std::nullopt : Integer();
}

Status TextScanner::Expected(std::string_view expected) {
  const bool at_end = AtLineEnd();
  const std::string got = at_end ? "the end of the line" : Quoted(Word());
  return Error(fmt::format("expected {}, got {}", expected, got));
}

Status TextScanner::Error(std::string_view message) const {
  return Status::InvalidInput(fmt::format("{}: {}", Place(), message));
}

std::string TextScanner::Place() const { return fmt::format("{}:{}", path_, line_); }

std::string_view TextScanner::BytesAfterLine() {
  SkipLine();
  started_ = false;
  return Rest();
}

std::string Printable(std::string_view word) {
  constexpr std::size_t kShown = 40;
  std::string shown;
  for (const char c : word.substr(0, kShown)) shown += c >= ' ' && c <= '~' ? c : '?';
  return word.size() > kShown ? shown + "..." : shown;
}

std::string Quoted(std::string_view word) { return fmt::format("'{}'", Printable(word)); }

}  // namespace cirque

#include "experiments/common/options_file.h"

#include <algorithm>

#include <fmt/format.h>

#include "cirque/io/file_input.h"
#include "cirque/io/io.h"

namespace cirque {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool IsBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

class OptionWords {
 public:
  OptionWords(const std::string& path, std::string_view text) : path_(path), text_(text) {
    if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
  }

  StatusOr<std::vector<std::string>> Read() {
    for (SkipBlanksAndComments(); !text_.empty(); SkipBlanksAndComments()) {
      std::string& word = words_.emplace_back();
      while (!text_.empty() && !IsBlank(text_.front())) {
        if (!AddTo(&word)) {
          return Status::InvalidInput(
              fmt::format("{}:{}: a quote is not closed on its line", path_, line_));
        }
      }
    }
    return std::move(words_);
  }

 private:
  void SkipBlanksAndComments() {
    bool in_comment = false;
    while (!text_.empty() && (in_comment || IsBlank(text_.front()) || text_.front() == '#')) {
      in_comment = text_.front() != '\n' && (in_comment || text_.front() == '#');
      line_ += text_.front() == '\n' ? 1 : 0;
      text_.remove_prefix(1);
    }
  }

  /// One character, or what stands between quotes; false where they do not close.
  bool AddTo(std::string* word) {
    const char c = text_.front();
    text_.remove_prefix(1);
    if (c != '"' && c != '\'') {
      *word += c;
      return true;
    }
    const std::size_t end = text_.find_first_of(std::string{c, '\n'});
    if (end == std::string_view::npos || text_[end] == '\n') return false;
    *word += text_.substr(0, end);
    text_.remove_prefix(end + 1);
    return true;
  }

  const std::string& path_;
  std::string_view text_;
  int line_ = 1;
  std::vector<std::string> words_;
};

}  // namespace

StatusOr<std::vector<std::string>> WordsOfOptions(const std::string& path, std::string_view text) {
  return OptionWords(path, text).Read();
}

StatusOr<std::vector<std::string>> ReadOptionsFile(const std::string& path) {
  const StatusOr<std::string> text = ReadFileContent(path);
  if (!text.ok()) {
    return Status::InvalidInput(path + ": cannot read this file of options; see --help");
  }
  const StatusOr<std::vector<std::string>> words = WordsOfOptions(path, *text);
  if (words.ok() && (words->empty() || words->front().starts_with('-'))) return words;
  const std::string extension = MeshExtension(path);
  const std::vector<std::string> known = ReadableExtensions();
  if (std::find(known.begin(), known.end(), extension) != known.end() ||
      ParseMesh(path, *text).ok()) {
    return Status::InvalidInput(fmt::format(
        "{}: this is a mesh, where a file of options was expected; write -io {}", path, path));
  }
  if (!words.ok()) return words;
  return Status::InvalidInput(fmt::format("{}: a file of options begins with one, this one with {}",
                                          path, Quoted(words->front())));
}

}  // namespace cirque

#include "tests/structure/public_headers.h"

#include <fstream>
#include <regex>
#include <sstream>

#include <fmt/format.h>

#include "tests/common/paths.h"
#include "tests/structure/code_text.h"

namespace cirque {
namespace {

std::vector<std::string> Lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool IsBlank(const std::string& line) { return line.find_first_not_of(" \t") == std::string::npos; }

// Above the declaration or, as `///<`, behind it.
bool IsExplanation(const std::string& line) {
  static const std::regex kExplanation(R"(^\s*///|///<)");
  return std::regex_search(line, kExplanation);
}

// Follows braces and statements from line to line.
class StatementReader {
 public:
  // Reads a line of code; afterwards the members tell of it.
  void Read(const std::string& code) {
    began_inside_ = in_statement_;
    const std::size_t depth = scopes_.size();
    opaque_ = depth > 0 && !scopes_.back();
    depth_ = static_cast<int>(depth);
    for (const char c : code) Read(c);
  }

  bool began_inside() const { return began_inside_; }  // a statement of an earlier line goes on
  bool opaque() const { return opaque_; }              // the line lies in a function or class
  int depth() const { return depth_; }                 // of namespaces

 private:
  void Read(char c) {
    if (c == '{') {
      scopes_.push_back(statement_.starts_with("namespace") || statement_.starts_with("extern"));
      if (scopes_.back()) End();
    } else if (c == '}') {
      if (!scopes_.empty()) scopes_.pop_back();
      if (IsOutside()) End();
    } else if (c == ';' && IsOutside() && parentheses_ == 0) {
      End();
    } else if (IsOutside()) {
      parentheses_ += c == '(' ? 1 : c == ')' ? -1 : 0;
      if (!in_statement_ && (c == ' ' || c == '\t')) return;
      in_statement_ = true;
      statement_ += c;
    }
  }

  // Whether only namespaces are open.
  bool IsOutside() const { return scopes_.empty() || scopes_.back(); }

  void End() {
    in_statement_ = false;
    statement_.clear();
  }

  std::vector<bool> scopes_;  // whether each open brace is a namespace's
  std::string statement_;
  int parentheses_ = 0, depth_ = 0;
  bool in_statement_ = false, began_inside_ = false, opaque_ = false;
};

bool NeedsNoExplanation(const std::string& code) {
  static const std::regex kFree(R"(^\s*(\}|namespace\b|(class|struct) \w+;|template <>))");
  return std::regex_search(code, kFree);
}

}  // namespace

std::vector<std::string> PublicHeaders() {
  std::vector<std::string> headers;
  std::ifstream file(ProjectPath("framework/public_headers.txt"));
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && !line.starts_with("#")) headers.push_back(line);
  }
  return headers;
}

std::vector<std::string> LibraryIncludes(const std::string& text) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*["<](cirque/[^">]+)[">])re");
  std::vector<std::string> includes;
  std::smatch match;
  for (const std::string& line : Lines(text)) {
    if (std::regex_search(line, match, kInclude)) includes.push_back(match[1]);
  }
  return includes;
}

std::vector<std::string> UnexplainedDeclarations(const std::string& text) {
  const std::vector<std::string> lines = Lines(text), code = Lines(CodeOf(text));
  std::vector<std::string> found;
  StatementReader reader;
  bool explained = false;  // what stands directly above explains this line too
  for (std::size_t i = 0; i < lines.size(); ++i) {
    reader.Read(code[i]);
    if (IsBlank(lines[i])) explained = false;
    if (IsExplanation(lines[i])) explained = true;
    if (IsBlank(code[i]) || reader.began_inside() || reader.opaque()) continue;
    // A member of a class template was explained in its class.
    const bool is_member = i + 1 < code.size() && code[i + 1].find(">::") != std::string::npos;
    if (NeedsNoExplanation(code[i]) || explained || is_member) continue;
    found.push_back(fmt::format("{}: {}", i + 1, lines[i]));
  }
  return found;
}

}  // namespace cirque

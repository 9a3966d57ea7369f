#include "tests/structure/code_text.h"

#include <algorithm>
#include <cctype>
#include <regex>

namespace cirque {
namespace {

bool IsWordCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Where what begins at text[i] ends (one behind it), when it is a comment, a literal or a
// preprocessor line; i when it is code.
class Blank {
 public:
  explicit Blank(const std::string& text) : text_(text) {}

  size_t End(size_t i) const {
    if (text_.compare(i, 2, "//") == 0) return LineEnd(i);
    if (text_.compare(i, 2, "/*") == 0) return Behind("*/", i + 2);
    if (text_[i] == '#' && IsFirstOfLine(i)) return DirectiveEnd(i);
    if (text_.compare(i, 2, "R\"") == 0 && (i == 0 || !IsWordCharacter(text_[i - 1]))) {
      const size_t open = text_.find('(', i);
      return Behind(")" + text_.substr(i + 2, open - i - 2) + "\"", open);
    }
    // An apostrophe behind a digit separates digits.
    const bool separates = text_[i] == '\'' && i > 0 && IsWordCharacter(text_[i - 1]);
    if (text_[i] == '"' || (text_[i] == '\'' && !separates)) return QuoteEnd(i);
    return i;
  }

 private:
  size_t LineEnd(size_t i) const { return std::min(text_.find('\n', i), text_.size()); }

  size_t Behind(const std::string& mark, size_t i) const {
    const size_t found = text_.find(mark, i);
    return found == std::string::npos ? text_.size() : found + mark.size();
  }

  bool IsFirstOfLine(size_t i) const {
    while (i > 0 && (text_[i - 1] == ' ' || text_[i - 1] == '\t')) --i;
    return i == 0 || text_[i - 1] == '\n';
  }

  size_t DirectiveEnd(size_t i) const {
    size_t end = LineEnd(i);
    while (end < text_.size() && text_[end - 1] == '\\') end = LineEnd(end + 1);
    return end;
  }

  size_t QuoteEnd(size_t i) const {
    const char quote = text_[i++];
    while (i < text_.size() && text_[i] != quote) i += text_[i] == '\\' ? 2 : 1;
    return std::min(i + 1, text_.size());
  }

  const std::string& text_;
};

// Reads code brace by brace and notes the bodies of functions.
class FunctionFinder {
 public:
  void Read(char c) {
    if (c == '\n') ++line_;
    if (c == '{') return Open();
    if (c == '}') return Close();
    if (depth_in_function_ > 0) return;
    if (c == '(') ++parentheses_;
    if (c == ')') --parentheses_;
    if (c == ';' && parentheses_ == 0) return Forget();
    if (statement_.empty() && std::isspace(static_cast<unsigned char>(c))) return;
    if (statement_.empty()) statement_line_ = line_;
    statement_ += c;
  }

  std::vector<FunctionSpan> Take() { return std::move(functions_); }

 private:
  void Open() {
    if (depth_in_function_ > 0) {
      ++depth_in_function_;
    } else if (parentheses_ > 0) {
      ++braces_in_parentheses_;
    } else if (OpensFunction()) {
      depth_in_function_ = 1;
    } else {
      Forget();
    }
  }

  void Close() {
    if (depth_in_function_ == 0 && braces_in_parentheses_ > 0) {
      --braces_in_parentheses_;
    } else if (depth_in_function_ == 0) {
      Forget();
    } else if (--depth_in_function_ == 0) {
      functions_.push_back({statement_line_, line_ - statement_line_ + 1});
      Forget();
    }
  }

  bool OpensFunction() const {
    static const std::regex kScope(
        R"(^(namespace|extern)\b|^[^(]*\b(class|struct|enum|union)\b[^(]*$)");
    static const std::regex kInitialiser(R"(=\s*$)");
    return statement_.find('(') != std::string::npos && !std::regex_search(statement_, kScope) &&
           !std::regex_search(statement_, kInitialiser);
  }

  void Forget() { statement_.clear(); }

  int line_ = 1;
  int depth_in_function_ = 0;
  int parentheses_ = 0;
  int braces_in_parentheses_ = 0;
  int statement_line_ = 1;
  std::string statement_;  // what was read since the last statement or brace outside functions
  std::vector<FunctionSpan> functions_;
};

// Reads code brace by brace and notes the types between namespaces.
class TypeFinder {
 public:
  void Read(char c) {
    if (c == '{') return Open();
    if (c == '}' && !scopes_.empty()) scopes_.pop_back();
    if (c == '}' || c == ';') return statement_.clear();
    statement_ += std::isspace(static_cast<unsigned char>(c)) ? ' ' : c;
  }

  std::vector<std::string> Take() { return std::move(types_); }

 private:
  void Open() {
    static const std::regex kNamespace(R"(^ *(?:inline )?namespace ?([\w:]*) *$)");
    static const std::regex kType(
        R"(^ *(?:template ?<.*> ?)?(?:class|struct|enum class|enum|union) (\w+)(?: final)? ?(?::[^:].*)?$)");
    const bool is_visible = std::find(scopes_.begin(), scopes_.end(), "") == scopes_.end();
    std::smatch match;
    std::string scope;  // without a name: nobody outside sees what is in it
    if (std::regex_match(statement_, match, kNamespace)) {
      if (match[1].length() > 0) scope = match[1].str() + "::";
    } else if (is_visible && std::regex_match(statement_, match, kType)) {
      std::string name;
      for (const std::string& outer : scopes_) name += outer;
      types_.push_back(name + match[1].str());
    }
    scopes_.push_back(scope);
    statement_.clear();
  }

  std::string statement_;  // since the last one's end
  std::vector<std::string> scopes_;
  std::vector<std::string> types_;
};

// "class NAME final : BASES {" of a definition.
const std::regex& ClassPattern() {
  static const std::regex kClass(
      R"(\b(?:class|struct)\s+(\w+)\s*(?:final\s*)?(?::([^:{};][^{};]*))?\{)");
  return kClass;
}

// The last name of each base in "public a::B<C>, private D".
std::vector<std::string> BaseNames(const std::string& bases) {
  std::string plain;
  int depth = 0;
  for (const char c : bases) {
    if (c == '<') ++depth;
    if (depth == 0) plain += c;
    if (c == '>') --depth;
  }
  static const std::regex kLastName(R"((\w+)\s*(?:,|$))");
  std::vector<std::string> names;
  for (std::sregex_iterator m(plain.begin(), plain.end(), kLastName), end; m != end; ++m) {
    names.push_back((*m)[1]);
  }
  return names;
}

}  // namespace

std::string CodeOf(const std::string& text) {
  const Blank blank(text);
  std::string code = text;
  for (size_t i = 0; i < text.size();) {
    const size_t end = blank.End(i);
    for (size_t k = i; k < end; ++k) code[k] = text[k] == '\n' ? '\n' : ' ';
    i = std::max(end, i + 1);
  }
  return code;
}

std::vector<FunctionSpan> FunctionsOf(const std::string& text) {
  FunctionFinder finder;
  for (const char c : CodeOf(text)) finder.Read(c);
  return finder.Take();
}

std::vector<std::string> ClassesOf(const std::string& text) {
  const std::string code = CodeOf(text);
  std::vector<std::string> names;
  for (std::sregex_iterator m(code.begin(), code.end(), ClassPattern()), end; m != end; ++m) {
    names.push_back((*m)[1]);
  }
  return names;
}

std::vector<std::string> VisibleTypesOf(const std::string& text) {
  TypeFinder finder;
  for (const char c : CodeOf(text)) finder.Read(c);
  return finder.Take();
}

std::vector<Derivation> DerivationsOf(const std::string& text) {
  const std::string code = CodeOf(text);
  std::vector<Derivation> derivations;
  for (std::sregex_iterator m(code.begin(), code.end(), ClassPattern()), end; m != end; ++m) {
    for (const std::string& base : BaseNames((*m)[2])) derivations.push_back({(*m)[1], base});
  }
  return derivations;
}

}  // namespace cirque

#include "experiments/run_experiment/config/config_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <sstream>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace cirque {
namespace {

constexpr std::size_t kMostProblems = 50;      // more are counted
constexpr std::size_t kMostBeforeCaret = 200;  // bytes of a source line, and as many behind

/// Blanks that take the room of `text` on a terminal: tabs stay, a multi-byte character takes one.
std::string BlanksFor(std::string_view text) {
  std::string blanks;
  for (const char c : text) {
    const bool continues_character = (static_cast<unsigned char>(c) & 0xC0) == 0x80;
    if (!continues_character) blanks += c == '\t' ? '\t' : ' ';
  }
  return blanks;
}

template <class T>
std::optional<T> ParseWhole(const std::string& text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

}  // namespace

Place PlaceOf(const YAML::Mark& mark) {
  return mark.is_null() ? Place() : Place{mark.line + 1, mark.column + 1};
}

Place PlaceOf(const YAML::Node& node) { return PlaceOf(node.Mark()); }

Diagnostics::Diagnostics(std::string path, const std::string& text) : path_(std::move(path)) {
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines_.push_back(line);
  }
}

void Diagnostics::Add(Place place, std::string message) {
  if (problems_.size() == kMostProblems) {
    ++num_more_;
  } else {
    problems_.push_back({place, std::move(message)});
  }
}

std::string Diagnostics::Text() const {
  std::vector<Problem> sorted = problems_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Problem& a, const Problem& b) {
    return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
  });
  std::string text;
  for (const Problem& problem : sorted) {
    text +=
        fmt::format("{}: {}\n{}", Locate(problem.place), problem.message, Excerpt(problem.place));
  }
  if (num_more_ > 0) text += fmt::format("{}: and {} more problems\n", path_, num_more_);
  return text;
}

std::string Diagnostics::Locate(Place place) const {
  return fmt::format("{}:{}:{}", path_, place.line, place.column);
}

std::string Diagnostics::Excerpt(Place place) const {
  if (place.line > static_cast<int>(lines_.size())) return {};
  std::string_view line = lines_[place.line - 1];
  std::size_t caret = std::min<std::size_t>(line.size(), place.column - 1);
  const std::size_t left_out = caret > kMostBeforeCaret ? caret - kMostBeforeCaret : 0;
  line = line.substr(left_out, 2 * kMostBeforeCaret);
  caret -= left_out;
  return fmt::format("  {}\n  {}^\n", line, BlanksFor(line.substr(0, caret)));
}

std::optional<long long> ParseInteger(const std::string& text) {
  return ParseWhole<long long>(text);
}

std::optional<double> ParseNumber(const std::string& text) {
  const std::optional<double> value = ParseWhole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<bool> ParseBoolean(const std::string& text) {
  if (text == "true") return true;
  if (text == "false") return false;
  return std::nullopt;
}

std::vector<YAML::Node> ItemsOf(const YAML::Node& value) {
  if (value && value.IsScalar()) return {value};
  if (!value || !value.IsSequence()) return {};
  return {value.begin(), value.end()};
}

std::vector<YAML::Node> EntriesOf(const YAML::Node& section) {
  if (section && section.IsMap()) return {section};
  return ItemsOf(section);
}

std::vector<std::string> DistinctItems(const YAML::Node& value, Diagnostics* problems) {
  std::vector<std::string> texts;
  std::set<std::string> seen;
  for (const YAML::Node& item : ItemsOf(value)) {
    if (!seen.insert(item.Scalar()).second) {
      problems->Add(PlaceOf(item), fmt::format("'{}' is listed twice", item.Scalar()));
      continue;
    }
    texts.push_back(item.Scalar());
  }
  return texts;
}

std::string TextOr(const YAML::Node& map, const char* key, const std::string& otherwise) {
  const YAML::Node value = map[key];
  return value ? value.Scalar() : otherwise;
}

}  // namespace cirque

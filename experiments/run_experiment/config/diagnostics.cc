#include "experiments/run_experiment/config/diagnostics.h"

#include <algorithm>
#include <sstream>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace cirque {
namespace {

/// Blanks that take the room of `text` on a terminal: tabs stay, a multi-byte character takes one.
std::string BlanksFor(std::string_view text) {
  std::string blanks;
  for (const char c : text) {
    const bool continues_character = (static_cast<unsigned char>(c) & 0xC0) == 0x80;
    if (!continues_character) blanks += c == '\t' ? '\t' : ' ';
  }
  return blanks;
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
  problems_.push_back({place, std::move(message)});
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
  return text;
}

std::string Diagnostics::Locate(Place place) const {
  return fmt::format("{}:{}:{}", path_, place.line, place.column);
}

std::string Diagnostics::Excerpt(Place place) const {
  if (place.line > static_cast<int>(lines_.size())) return {};
  const std::string& line = lines_[place.line - 1];
  return fmt::format("  {}\n  {}^\n", line,
                     BlanksFor(std::string_view(line).substr(
                         0, std::min<std::size_t>(line.size(), place.column - 1))));
}

}  // namespace cirque

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

namespace cirque {

/// A place in a text file, both numbers from 1.
struct Place {
  int line = 1, column = 1;
};

Place PlaceOf(const YAML::Mark& mark);
Place PlaceOf(const YAML::Node& node);

/// Collects the problems of one text file, so that its author sees all of them at once, or the first
/// fifty found.
class Diagnostics {
 public:
  Diagnostics(std::string path, const std::string& text);

  void Add(Place place, std::string message);
  bool empty() const { return problems_.empty(); }

  /// Every problem in the order of the file: "path:line:column: message", the source line, a caret.
  std::string Text() const;

  /// "path:line:column".
  std::string Locate(Place place) const;

 private:
  struct Problem {
    Place place;
    std::string message;
  };

  std::string Excerpt(Place place) const;

  std::string path_;
  std::vector<std::string> lines_;
  std::vector<Problem> problems_;
  int num_more_ = 0;  ///< than are kept
};

/// One value or a list of them; nothing where the key is not given, or has a map.
std::vector<YAML::Node> ItemsOf(const YAML::Node& value);

/// Their texts. One that stands there twice is a problem.
std::vector<std::string> DistinctItems(const YAML::Node& value, Diagnostics* problems);

/// The maps of a section: of a list of them, or the one that stands in place of a list.
std::vector<YAML::Node> EntriesOf(const YAML::Node& section);

/// The text of a key's value, or `otherwise` where the key is not given.
std::string TextOr(const YAML::Node& map, const char* key, const std::string& otherwise);

/// The whole text as a number, or nothing: no octal, no trailing characters, no infinities.
std::optional<long long> ParseInteger(const std::string& text);
std::optional<double> ParseNumber(const std::string& text);

/// "true" and "false" only: YAML's other spellings of them are a trap.
std::optional<bool> ParseBoolean(const std::string& text);

}  // namespace cirque

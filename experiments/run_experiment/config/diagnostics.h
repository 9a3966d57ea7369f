#pragma once

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

/// Collects the problems of one text file, so that its author sees all of them at once.
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
};

}  // namespace cirque

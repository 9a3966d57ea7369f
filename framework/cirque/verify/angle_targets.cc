#include "cirque/verify/angle_targets.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

namespace cirque::verify {
namespace {

std::optional<double> ParseNumber(const std::string& word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// The words of a line up to a comment.
std::vector<std::string> Words(const std::string& line) {
  std::istringstream text(line.substr(0, line.find('#')));
  std::vector<std::string> words;
  for (std::string word; text >> word;) words.push_back(word);
  return words;
}

/// Empty, or what is wrong.
std::string AddSum(const std::vector<std::string>& words, AngleTargets* targets) {
  const std::optional<double> sum = ParseNumber(words[0]);
  if (words.size() != 1 || (!sum && words[0] != "free")) {
    return fmt::format("'{}' is no angle sum; write radians, or free", words[0]);
  }
  targets->at.push_back(sum ? std::optional(AngleInterval{*sum / kPi, *sum / kPi}) : std::nullopt);
  return "";
}

std::string AddCone(const std::vector<std::string>& words, Index num_vertices,
                    AngleTargets* targets) {
  const std::optional<double> vertex = ParseNumber(words[0]);
  if (!vertex || *vertex != std::floor(*vertex) || *vertex < 1 || *vertex > num_vertices) {
    return fmt::format("no vertex '{}'; they are 1 to {}", words[0], num_vertices);
  }
  const std::optional<double> lower = words.size() > 1 ? ParseNumber(words[1]) : std::nullopt;
  const std::optional<double> upper = words.size() > 2 ? ParseNumber(words[2]) : lower;
  if (words.size() > 3 || !lower || !upper || !(*lower <= *upper)) {
    return "a cone is 'vertex angle' or 'vertex min max', in units of pi";
  }
  std::optional<AngleInterval>& target = targets->at[static_cast<std::size_t>(*vertex) - 1];
  if (target) return fmt::format("vertex {} is named twice", words[0]);
  target = AngleInterval{*lower, *upper};
  return "";
}

}  // namespace

AngleTargets DefaultTargets() {
  AngleTargets targets;
  targets.flat_elsewhere = true;
  return targets;
}

StatusOr<AngleTargets> ReadTargets(const std::string& path, Index num_vertices) {
  std::ifstream file(path);
  if (!file) return Status::InvalidInput(fmt::format("{}: cannot be read", path));
  AngleTargets targets;
  std::string line;
  bool first = true;
  for (int number = 1; std::getline(file, line); ++number) {
    const std::vector<std::string> words = Words(line);
    if (words.empty()) continue;
    if (first) targets.flat_elsewhere = words.size() > 1;
    if (first && targets.flat_elsewhere) targets.at.resize(num_vertices);
    first = false;
    const std::string problem =
        targets.flat_elsewhere ? AddCone(words, num_vertices, &targets) : AddSum(words, &targets);
    if (!problem.empty()) {
      return Status::InvalidInput(fmt::format("{}:{}: {}", path, number, problem));
    }
  }
  if (static_cast<Index>(targets.at.size()) == num_vertices) return targets;
  return Status::InvalidInput(
      fmt::format("{}: {} angle sums for {} vertices; one line each is needed", path,
                  targets.at.size(), num_vertices));
}

}  // namespace cirque::verify

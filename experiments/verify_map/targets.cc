#include <charconv>
#include <cmath>
#include <fstream>

#include <fmt/format.h>

#include "experiments/verify_map/angle_check.h"

namespace cirque::verify_map {
namespace {

std::string Trimmed(const std::string& line) {
  const char* const kBlank = " \t\r";
  const std::size_t begin = line.find_first_not_of(kBlank);
  if (begin == std::string::npos) return {};
  return line.substr(begin, line.find_last_not_of(kBlank) - begin + 1);
}

}  // namespace

StatusOr<std::vector<std::optional<double>>> ReadTargets(const std::string& path,
                                                         Index num_vertices) {
  std::ifstream file(path);
  if (!file) return Status::InvalidInput(fmt::format("{}: cannot be read", path));
  std::vector<std::optional<double>> targets;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    const std::string word = Trimmed(line);
    if (word.empty()) continue;
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_number =
        error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
    if (!is_number && word != "free") {
      return Status::InvalidInput(
          fmt::format("{}:{}: '{}' is no angle sum; write radians, or free", path, number, word));
    }
    targets.push_back(is_number ? std::optional<double>(value) : std::nullopt);
  }
  if (static_cast<Index>(targets.size()) == num_vertices) return targets;
  return Status::InvalidInput(
      fmt::format("{}: {} angle sums for {} vertices; one line each is needed", path,
                  targets.size(), num_vertices));
}

}  // namespace cirque::verify_map

#include "cirque/math/inscribed_polygon.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace cirque {
namespace {

constexpr double kCloses = 0.999;  ///< of the others' sum: the most that one edge may be long
constexpr int kHalvings = 60;      ///< of an interval, to the last bit

/// The sum of asin(l_i s) over all edges but the longest.
double OthersTurn(const std::vector<double>& lengths, std::size_t longest, double s) {
  double turn = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    if (i != longest) turn += std::asin(std::min(1.0, lengths[i] * s));
  }
  return turn;
}

}  // namespace

std::vector<double> HalfCentralAngles(std::vector<double> lengths) {
  const auto longest =
      static_cast<std::size_t>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
  const double others = std::accumulate(lengths.begin(), lengths.end(), 0.0) - lengths[longest];
  lengths[longest] = std::min(lengths[longest], kCloses * others);
  const double most = 1 / *std::max_element(lengths.begin(), lengths.end());
  // The centre lies beyond the longest edge where the others do not come half way round on its circle.
  const bool beyond = OthersTurn(lengths, longest, most) < std::numbers::pi / 2;
  const auto turns_enough = [&](double s) {
    const double own = std::asin(std::min(1.0, lengths[longest] * s));
    const double turn = OthersTurn(lengths, longest, s);
    return beyond ? turn < own : turn + own > std::numbers::pi;
  };
  double low = 0, high = most;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = (low + high) / 2;
    (turns_enough(middle) ? high : low) = middle;
  }
  std::vector<double> half(lengths.size());
  double rest = std::numbers::pi;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    if (i == longest) continue;
    half[i] = std::asin(std::min(1.0, lengths[i] * high));
    rest -= half[i];
  }
  half[longest] = rest;
  return half;
}

}  // namespace cirque

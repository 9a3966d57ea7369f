#include "cirque/metrics/colour_scale.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cirque {
namespace {

using Table = std::array<Colour, 9>;

constexpr Colour kGrey = {128, 128, 128};

/// OKLab lightness 0.24 to 0.95, hue 300 to 105 degrees, chroma 0.13 or what sRGB has there.
constexpr Table kOneSidedTable = {{{43, 0, 81},
                                   {38, 40, 118},
                                   {4, 77, 139},
                                   {6, 111, 143},
                                   {8, 144, 153},
                                   {7, 178, 154},
                                   {108, 205, 142},
                                   {182, 226, 133},
                                   {251, 244, 136}}};

/// OKLab lightness 0.4, 0.95, 0.4, hue 255 and 35 degrees, chroma growing to 0.17.
constexpr Table kTwoSidedTable = {{{1, 70, 140},
                                   {48, 110, 186},
                                   {109, 153, 210},
                                   {170, 196, 230},
                                   {238, 238, 238},
                                   {227, 182, 170},
                                   {203, 128, 109},
                                   {174, 75, 51},
                                   {130, 30, 1}}};

}  // namespace

Colour ColourOnScale(double value, double least, double greatest) {
  if (std::isnan(value)) return kGrey;
  const Table& table = least < 0 && greatest > 0 ? kTwoSidedTable : kOneSidedTable;
  const double share = std::clamp((value - least) / (greatest - least), 0.0, 1.0);
  const double place = share * static_cast<double>(table.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), table.size() - 2);
  const double weight = place - static_cast<double>(below);
  Colour colour;
  for (std::size_t i = 0; i < 3; ++i) {
    colour[i] = static_cast<int>(
        std::lround((1 - weight) * table[below][i] + weight * table[below + 1][i]));
  }
  return colour;
}

}  // namespace cirque

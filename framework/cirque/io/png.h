#pragma once

#include <string>

namespace cirque {

/// zlib's format (RFC 1950), which browsers call "deflate".
std::string Deflate(const std::string& bytes);

/// What a pixel of a PNG has: grey or red, green and blue, and opacity or none.
enum class PngColour : char { kGrey = 0, kRgb = 2, kGreyAlpha = 4, kRgba = 6 };

/// A picture as PNG (ISO 15948), not interlaced. `rows`: for every row the number of its filter, then
/// its bytes as that filter leaves them (0: as they are). `bits` of each number: 8, or 16, the higher
/// byte first.
std::string FormatPng(int width, int height, PngColour colour, const std::string& rows,
                      int bits = 8);

}  // namespace cirque

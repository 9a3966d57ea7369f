#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cirque/core/status.h"

namespace cirque {

/// A picture of whole numbers: grey (1 channel), grey and opacity (2), red, green and blue (3) or
/// these and opacity (4).
struct Image {
  int width = 0, height = 0, channels = 1;
  int most = 255;                     ///< of a sample: 255, 65535, or as a Netpbm file says
  std::vector<std::uint16_t> sample;  ///< height x width x channels, rows from above
};

/// The picture that a file of that name has, by its content: PNG (ISO 15948; 8 or 16 bits, without
/// palette, not interlaced) or Netpbm's P5 and P6. Errors (invalid input): another or a damaged
/// file, one of more than 2^28 samples.
StatusOr<Image> ParseImage(const std::string& path, std::string_view content);

StatusOr<Image> ReadImage(const std::string& path);

/// Writes it by its file name's extension, atomically: .png (8 or 16 bits), .pgm (1 channel) or .ppm
/// (3). Error (invalid input): another name, or channels or a greatest sample that it does not hold.
Status WriteImage(const std::string& path, const Image& image);

}  // namespace cirque

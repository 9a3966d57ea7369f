#include "experiments/experiment_report/byte_stream.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>

#include <glog/logging.h>

namespace cirque::experiment_report {
namespace {

constexpr double kSteps = 65535;

/// Folds the sign of a difference into its lowest bit.
template <class Signed>
std::uint32_t Fold(Signed difference) {
  const auto wide = static_cast<std::int64_t>(difference);
  return static_cast<std::uint32_t>(wide >= 0 ? 2 * wide : -2 * wide - 1);
}

}  // namespace

void ByteStream::AddShorts(const std::vector<std::uint16_t>& values) {
  std::vector<std::uint32_t> codes;
  std::uint16_t before = 0;
  for (const std::uint16_t value : values) {
    codes.push_back(Fold(static_cast<std::int16_t>(value - before)));
    before = value;
  }
  AddPlanes(codes, 2);
}

void ByteStream::AddWords(const std::vector<std::uint32_t>& values) {
  std::vector<std::uint32_t> codes;
  std::uint32_t before = 0;
  for (const std::uint32_t value : values) {
    codes.push_back(Fold(static_cast<std::int32_t>(value - before)));
    before = value;
  }
  AddPlanes(codes, 4);
}

void ByteStream::AddPlanes(const std::vector<std::uint32_t>& codes, int planes) {
  for (int plane = 0; plane < planes; ++plane) {
    for (const std::uint32_t code : codes) {
      bytes_.push_back(static_cast<char>(code >> (8 * plane) & 0xff));
    }
  }
}

std::vector<std::uint16_t> Quantize(const std::vector<double>& values, double low, double high) {
  const double scale = high > low ? kSteps / (high - low) : 0;
  std::vector<std::uint16_t> steps;
  for (const double value : values) {
    const double step = std::isnan(value) ? 0 : std::clamp((value - low) * scale, 0.0, kSteps);
    steps.push_back(static_cast<std::uint16_t>(std::lround(step)));
  }
  return steps;
}

std::string Deflate(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string deflated(size, '\0');
  const int result =
      compress2(reinterpret_cast<Bytef*>(deflated.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION);
  CHECK_EQ(result, Z_OK);  // the bound holds always
  deflated.resize(size);
  return deflated;
}

std::string Base64(const std::string& bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

}  // namespace cirque::experiment_report

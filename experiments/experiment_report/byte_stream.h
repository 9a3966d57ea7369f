#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cirque::experiment_report {

/// Bytes in the order in which assets/mesh_payload.js reads them. A list of N values of 2 or 4
/// bytes is written as its differences d (modulo 2^16 or 2^32, from 0), each folded to
/// 2 d or -2 d - 1 so that small ones are small numbers, and these as N low bytes, then N next
/// bytes and so on: what neighbours in a mesh have in common then deflates well.
class ByteStream {
 public:
  void AddShorts(const std::vector<std::uint16_t>& values);
  void AddWords(const std::vector<std::uint32_t>& values);

  const std::string& bytes() const { return bytes_; }

 private:
  void AddPlanes(const std::vector<std::uint32_t>& codes, int planes);

  std::string bytes_;
};

/// The nearest of the 2^16 numbers from `low` (0) to `high` (65535) to each value;
/// what lies outside is clamped, NaN counts as low.
std::vector<std::uint16_t> Quantize(const std::vector<double>& values, double low, double high);

/// zlib's format (RFC 1950), which browsers call "deflate".
std::string Deflate(const std::string& bytes);

/// RFC 4648, with padding.
std::string Base64(const std::string& bytes);

}  // namespace cirque::experiment_report

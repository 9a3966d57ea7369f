#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>

namespace cirque {

enum class ByteOrder { kLittle, kBig };

/// The number of type T in the first sizeof(T) bytes; there must be as many.
template <class T>
T ReadBytes(std::string_view bytes, ByteOrder order) {
  char raw[sizeof(T)];
  std::copy_n(bytes.data(), sizeof(T), raw);
  if ((order == ByteOrder::kLittle) != (std::endian::native == std::endian::little)) {
    std::reverse(raw, raw + sizeof(T));
  }
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

}  // namespace cirque

#pragma once

#include <cstdint>
#include <string>

namespace cirque::testing {

/// A quadrilateral as OM of version 1: positions of doubles, the face by its vertices.
inline std::string OmOfQuadrilateral() {
  std::string bytes = "OMP\x22";
  const auto append = [&](auto value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (const std::uint32_t count : {4U, 1U, 4U}) append(count);
  append(std::uint16_t{0x5600});
  for (const double x : {0., 0., 0., 1., 0., 0., 1., 1., 0., 0., 1., 0.}) append(x);
  append(std::uint16_t{0x42e8});
  for (const int n : {4, 0, 1, 2, 3, 0x1c}) append(static_cast<std::uint16_t>(n));
  return bytes;
}

}  // namespace cirque::testing

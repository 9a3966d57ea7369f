#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace cirque {

/// The SHA-256 digest of bytes (FIPS 180-4): by it a page's content-security policy names the scripts
/// that may run in it.
std::array<std::uint8_t, 32> Sha256(std::string_view bytes);

}  // namespace cirque

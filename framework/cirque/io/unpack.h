#pragma once

#include <string>
#include <vector>

#include "cirque/core/status.h"

namespace cirque {

/// What a packed file may swell to: this many times its size, and a megabyte in any case. Meshes as
/// text shrink to a third or a tenth; what swells more fills the memory and is no mesh.
constexpr std::size_t kMostSwelling = 200;

/// The bytes of a file as parsers take them, out of those that it has:
///  - gzip (its first bytes tell) is unpacked, several members one after the other; what is no
///    member behind them is passed over with a warning, a damaged or cut one refused, and what swells
///    to more than kMostSwelling times its size;
///  - UTF-16 (its byte order mark tells) becomes UTF-8, with a warning.
/// `path` leads the messages.
StatusOr<std::string> Unpacked(const std::string& path, std::string content,
                               std::vector<std::string>* warnings);

/// The same of a file; "-" is the standard input.
StatusOr<std::string> ReadUnpacked(const std::string& path, std::vector<std::string>* warnings);

}  // namespace cirque

#pragma once

#include <string>
#include <string_view>

#include "cirque/core/status.h"

namespace cirque {

/// The content of a file inside an archive (tar, zip, 7z, ..., compressed or not), or of a file
/// that is only compressed, whose one member is called "data". Errors name the archive and, for an
/// unknown member, the nearest name in it; a member of more than 64 MiB that is also more than 200
/// times as large as the archive is refused as a trap.
StatusOr<std::string> ReadArchiveMember(const std::string& archive, const std::string& member);

/// Whether the archive has the member, without reading its content; the same errors.
Status FindArchiveMember(const std::string& archive, const std::string& member);

/// 16 hexadecimal digits (XXH3, 64 bits) that name a content; not meant to withstand an attacker.
std::string HashOf(std::string_view content);

/// The bytes of a regular file; errors name it.
StatusOr<std::string> ReadWholeFile(const std::string& path);

}  // namespace cirque

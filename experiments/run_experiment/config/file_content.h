#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "cirque/core/status.h"

namespace cirque {

/// The content of a file inside an archive (tar, zip, 7z, ..., compressed or not), or of a file
/// that is only compressed, whose one member is called "data". Errors name the archive and, for an
/// unknown member, the nearest name in it; a member of more than 64 MiB that is also more than 200
/// times as large as the archive is refused as a trap.
StatusOr<std::string> ReadArchiveMember(const std::string& archive, const std::string& member);

/// The names of the files in an archive, in its order.
StatusOr<std::vector<std::string>> ArchiveMembers(const std::string& archive);

/// Hands the content of each of the archive's members of these names to `take`, which is read once,
/// in its order; ends with the first status that is not ok. Members that are not there are passed
/// over; else the errors of ReadArchiveMember.
Status ReadArchiveMembers(
    const std::string& archive, const std::set<std::string>& members,
    const std::function<Status(const std::string& member, const std::string& content)>& take);

/// Whether the archive has the member, without reading its content; the same errors.
Status FindArchiveMember(const std::string& archive, const std::string& member);

/// 16 hexadecimal digits (XXH3, 64 bits) that name a content; not meant to withstand an attacker.
std::string HashOf(std::string_view content);

/// The bytes of a regular file; errors name it.
StatusOr<std::string> ReadWholeFile(const std::string& path);

}  // namespace cirque

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cirque/core/status.h"

namespace cirque {

/// A text's pieces, one after another.
using TextPieces = std::vector<std::string>;

/// Writes `content` to `path` whole or not at all. A regular file, or one that is not there yet, is
/// replaced by a new one once that lies on the disk (fsync, then rename); it keeps the mode of the
/// one before. Until then the new file has no name where the file system can do without, so that
/// nothing stays behind however the process ends. Links are followed. What is no regular file (a
/// pipe, a device, a descriptor of this process as /dev/stdout or /dev/fd/3) is written into as it
/// is. On failure the status names the path and the system's reason: kResource where the disk is
/// full or failing, else kInvalidInput.
Status WriteFileAtomically(const std::string& path, std::string_view content);
Status WriteFileAtomically(const std::string& path, const TextPieces& content);

/// Whether WriteFileAtomically may hope to write to `path`: its folder is there and may be written
/// to, and it is itself no folder. To be asked before long work whose result goes there.
Status CheckOutputPath(const std::string& path);

}  // namespace cirque

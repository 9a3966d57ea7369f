#include "experiments/run_experiment/config/content_hash.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include <fmt/format.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace cirque {

std::string HashOf(std::string_view content) {
  return fmt::format("{:016x}", XXH3_64bits(content.data(), content.size()));
}

StatusOr<std::string> ReadWholeFile(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    return Status::InvalidInput(path + ": is a folder, not a file");
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    return Status::InvalidInput(fmt::format("{}: cannot open: {}", path, std::strerror(errno)));
  }
  std::string content;
  std::vector<char> block(1 << 20);
  while (stream.read(block.data(), static_cast<std::streamsize>(block.size())),
         stream.gcount() > 0) {
    content.append(block.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) return Status::InvalidInput(path + ": cannot be read to its end");
  return content;
}

}  // namespace cirque

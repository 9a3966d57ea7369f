#include "cirque/io/file_content.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include <fmt/format.h>

namespace cirque {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

Status Failure(const std::string& path) {
  return Status::InvalidInput(fmt::format("{}: cannot read: {}", path, std::strerror(errno)));
}

/// What the system expects a read to return; a pipe says 0.
std::size_t ExpectedSize(std::FILE* file) {
  struct stat information = {};
  const bool known = fstat(fileno(file), &information) == 0 && S_ISREG(information.st_mode);
  return known ? static_cast<std::size_t>(information.st_size) : 0;
}

}  // namespace

StatusOr<std::string> ReadFileContent(const std::string& path) {
  std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file) return Failure(path);
  std::string content;
  std::size_t size = 0;
  // One byte more than expected, so that the read that fills a regular file also sees its end.
  for (std::size_t room = ExpectedSize(file.get()) + 1;;
       room = std::max(size, std::size_t{65536})) {
    content.resize(size + room);
    const std::size_t got = std::fread(content.data() + size, 1, room, file.get());
    size += got;
    if (got < room) break;
  }
  if (std::ferror(file.get()) != 0) return Failure(path);
  content.resize(size);
  return content;
}

}  // namespace cirque

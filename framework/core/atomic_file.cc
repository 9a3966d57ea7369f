#include "cirque/core/atomic_file.h"

#include <unistd.h>

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

Status Failure(const std::string& path, const char* action) {
  return Status::InvalidInput(fmt::format("{}: cannot {}: {}", path, action, std::strerror(errno)));
}

/// Writes to `temporary` on the way to `path`, which failures name.
Status WriteAll(const std::string& temporary, const std::string& path, std::string_view content) {
  std::unique_ptr<std::FILE, CloseFile> file(std::fopen(temporary.c_str(), "wb"));
  if (!file) return Failure(path, "open for writing");
  if (std::fwrite(content.data(), 1, content.size(), file.get()) != content.size() ||
      std::fflush(file.get()) != 0) {
    return Failure(path, "write");
  }
  return Status();
}

}  // namespace

Status WriteFileAtomically(const std::string& path, std::string_view content) {
  const std::string temporary = fmt::format("{}.tmp.{}", path, getpid());
  Status status = WriteAll(temporary, path, content);
  if (status.ok() && std::rename(temporary.c_str(), path.c_str()) != 0) {
    status = Failure(path, "replace");
  }
  if (!status.ok()) std::remove(temporary.c_str());
  return status;
}

}  // namespace cirque

#include "cirque/core/atomic_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <span>

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
Status WriteAll(const std::string& temporary, const std::string& path,
                std::span<const std::string_view> pieces) {
  std::unique_ptr<std::FILE, CloseFile> file(std::fopen(temporary.c_str(), "wb"));
  if (!file) return Failure(path, "open for writing");
  for (const std::string_view piece : pieces) {
    if (std::fwrite(piece.data(), 1, piece.size(), file.get()) != piece.size()) {
      return Failure(path, "write");
    }
  }
  return std::fflush(file.get()) == 0 ? Status() : Failure(path, "write");
}

Status WriteAndRename(const std::string& path, std::span<const std::string_view> pieces) {
  const std::string temporary = fmt::format("{}.tmp.{}", path, getpid());
  Status status = WriteAll(temporary, path, pieces);
  if (status.ok() && std::rename(temporary.c_str(), path.c_str()) != 0) {
    status = Failure(path, "replace");
  }
  if (!status.ok()) std::remove(temporary.c_str());
  return status;
}

}  // namespace

Status WriteFileAtomically(const std::string& path, std::string_view content) {
  return WriteAndRename(path, {&content, 1});
}

Status WriteFileAtomically(const std::string& path, const TextPieces& content) {
  const std::vector<std::string_view> pieces(content.begin(), content.end());
  return WriteAndRename(path, pieces);
}

}  // namespace cirque

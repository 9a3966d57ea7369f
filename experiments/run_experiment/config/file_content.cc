#include "experiments/run_experiment/config/file_content.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/core/text.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace cirque {
namespace {

constexpr std::size_t kBlockSize = 1 << 16;
/// A mesh that takes more than this, and more than so many times its archive, is a trap.
constexpr std::uintmax_t kHarmlessSize = 64 << 20, kMostGrowth = 200;
constexpr std::size_t kMostMembers = 1000000;

struct FreeArchive {
  void operator()(::archive* handle) const { archive_read_free(handle); }
};
using ArchiveHandle = std::unique_ptr<::archive, FreeArchive>;

Status Failure(const std::string& path, ::archive* handle) {
  const char* reason = archive_error_string(handle);
  return Status::InvalidInput(
      fmt::format("{}: cannot be read as an archive: {}", path, reason ? reason : "unknown error"));
}

/// Tar, zip, 7z and their like first; a plainly compressed file counts as an archive of one member.
StatusOr<ArchiveHandle> Open(const std::string& path) {
  ArchiveHandle handle(archive_read_new());
  archive_read_support_filter_all(handle.get());
  archive_read_support_format_all(handle.get());
  archive_read_support_format_raw(handle.get());
  if (archive_read_open_filename(handle.get(), path.c_str(), kBlockSize) != ARCHIVE_OK) {
    return Failure(path, handle.get());
  }
  return handle;
}

/// Moves to the header of the member.
Status Seek(const std::string& path, const std::string& member, ::archive* handle) {
  std::vector<std::string> known;
  archive_entry* entry = nullptr;
  int code = ARCHIVE_OK;
  while ((code = archive_read_next_header(handle, &entry)) == ARCHIVE_OK || code == ARCHIVE_WARN) {
    const char* name = archive_entry_pathname(entry);
    if (name == nullptr) continue;
    if (name == member) return Status();
    known.push_back(name);
    if (known.size() == kMostMembers) {
      return Status::InvalidInput(
          fmt::format("{} has no member '{}' among its first {}", path, member, kMostMembers));
    }
  }
  if (code != ARCHIVE_EOF) return Failure(path, handle);
  const std::string nearest = NearestWord(member, known);
  return Status::InvalidInput(
      fmt::format("{} has no member '{}' among its {}{}", path, member, known.size(),
                  nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest)));
}

/// The most bytes that a member of the archive may have.
std::uintmax_t MostContent(const std::string& archive) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(archive, error);
  return error ? kHarmlessSize : std::max(kHarmlessSize, size * kMostGrowth);
}

/// The content of the member whose header was read last.
StatusOr<std::string> ReadContent(const std::string& archive, const std::string& member,
                                  ::archive* handle) {
  const std::uintmax_t most = MostContent(archive);
  std::string content;
  std::vector<char> block(kBlockSize);
  la_ssize_t size = 0;
  while ((size = archive_read_data(handle, block.data(), block.size())) > 0) {
    content.append(block.data(), static_cast<std::size_t>(size));
    if (content.size() > most) {
      return Status::InvalidInput(fmt::format(
          "{}: its member '{}' has more than {} MiB, over {} times the archive's own size; if that "
          "is meant, unpack it and give it as 'file'",
          archive, member, most >> 20, kMostGrowth));
    }
  }
  if (size < 0) return Failure(archive, handle);
  return content;
}

/// Visits the files of an archive, at most kMostMembers; `visit` may read their content.
Status VisitArchive(const std::string& path,
                    const std::function<Status(const std::string& name, ::archive*)>& visit) {
  const StatusOr<ArchiveHandle> handle = Open(path);
  if (!handle.ok()) return handle.status();
  archive_entry* entry = nullptr;
  int code = ARCHIVE_OK;
  std::size_t count = 0;
  while ((code = archive_read_next_header(handle->get(), &entry)) == ARCHIVE_OK ||
         code == ARCHIVE_WARN) {
    const char* name = archive_entry_pathname(entry);
    if (name == nullptr || archive_entry_filetype(entry) != AE_IFREG) continue;
    if (++count > kMostMembers) {
      return Status::InvalidInput(fmt::format("{} has more than {} members", path, kMostMembers));
    }
    if (Status status = visit(name, handle->get()); !status.ok()) return status;
  }
  return code == ARCHIVE_EOF ? Status() : Failure(path, handle->get());
}

}  // namespace

StatusOr<std::string> ReadArchiveMember(const std::string& archive, const std::string& member) {
  StatusOr<ArchiveHandle> handle = Open(archive);
  if (!handle.ok()) return handle.status();
  if (Status status = Seek(archive, member, handle->get()); !status.ok()) return status;
  return ReadContent(archive, member, handle->get());
}

StatusOr<std::vector<std::string>> ArchiveMembers(const std::string& archive) {
  std::vector<std::string> names;
  const Status status = VisitArchive(archive, [&](const std::string& name, ::archive*) {
    names.push_back(name);
    return Status();
  });
  return status.ok() ? StatusOr<std::vector<std::string>>(std::move(names)) : status;
}

Status ReadArchiveMembers(
    const std::string& archive, const std::set<std::string>& members,
    const std::function<Status(const std::string& member, const std::string& content)>& take) {
  return VisitArchive(archive, [&](const std::string& name, ::archive* handle) {
    if (!members.contains(name)) return Status();
    const StatusOr<std::string> content = ReadContent(archive, name, handle);
    return content.ok() ? take(name, *content) : content.status();
  });
}

Status FindArchiveMember(const std::string& archive, const std::string& member) {
  const StatusOr<ArchiveHandle> handle = Open(archive);
  return handle.ok() ? Seek(archive, member, handle->get()) : handle.status();
}

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

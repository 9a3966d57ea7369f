#include "cirque/core/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <random>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace cirque {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as many as Linux follows
constexpr int kMostNames = 100;
constexpr mode_t kNewFileMode = 0666;  // less the umask
constexpr mode_t kPermissions = 07777;

/// A descriptor that is closed at the end; negative: none.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  ~Descriptor() { Close(); }
  Descriptor& operator=(Descriptor&&) = delete;

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  bool Close() { return number_ < 0 || close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

Status Failure(const std::string& path, const char* action, int error = errno) {
  const bool of_machine = error == ENOSPC || error == EDQUOT || error == EIO || error == ENOMEM ||
                          error == EMFILE || error == ENFILE || error == EFBIG;
  return {of_machine ? StatusCode::kResource : StatusCode::kInvalidInput,
          fmt::format("{}: cannot {}: {}", path, action, std::strerror(error))};
}

bool WriteAll(int file, std::span<const std::string_view> pieces) {
  for (std::string_view piece : pieces) {
    while (!piece.empty()) {
      const ssize_t written = write(file, piece.data(), piece.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      piece.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  return true;
}

/// N where `path` is that of descriptor N of this process.
std::optional<int> OwnDescriptor(std::string_view path) {
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder)) continue;
    const std::string_view digits = path.substr(folder.size());
    int number = -1;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error == std::errc() && end == digits.data() + digits.size()) return number;
  }
  return std::nullopt;
}

/// Where the links from `path` lead, be there a file or not.
StatusOr<std::string> FollowLinks(const std::string& path) {
  fs::path target = path;
  for (int i = 0; i < kMostLinks; ++i) {
    if (OwnDescriptor(target.string())) return target.string();
    std::error_code error;
    const fs::path next = fs::read_symlink(target, error);
    if (error) return target.string();
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return Failure(path, "open for writing", ELOOP);
}

std::string FolderOf(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// A name beside `path` that nobody else will think of.
std::string NameBeside(const std::string& path) {
  std::random_device random;
  return fmt::format("{}.tmp.{:08x}{:08x}", path, random(), random());
}

/// The new file on its way: without a name at first, or with one where the file system wants one.
struct NewFile {
  Descriptor file;
  std::string name;
};

NewFile Create(const std::string& path) {
  Descriptor nameless(open(FolderOf(path).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kNewFileMode));
  if (nameless.is_open()) return {std::move(nameless), ""};
  // Not every file system has files without a name; whatever else is wrong will be so again.
  for (int i = 0; i < kMostNames; ++i) {
    std::string name = NameBeside(path);
    Descriptor file(open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, kNewFileMode));
    if (file.is_open() || errno != EEXIST) return {std::move(file), std::move(name)};
  }
  return {Descriptor(-1), ""};
}

bool GiveName(NewFile* file, const std::string& path) {
  const std::string link = fmt::format("/proc/self/fd/{}", file->file.number());
  for (int i = 0; i < kMostNames; ++i) {
    const std::string name = NameBeside(path);
    if (linkat(AT_FDCWD, link.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) {
      file->name = name;
      return true;
    }
    if (errno != EEXIST) return false;
  }
  return false;
}

/// Writes, then replaces `target`; failures name `path`, as the caller knows it.
Status Replace(const std::string& target, const std::string& path, const struct stat* before,
               std::span<const std::string_view> pieces) {
  if (before && access(target.c_str(), W_OK) != 0) return Failure(path, "replace");
  NewFile file = Create(target);
  if (!file.file.is_open()) return Failure(path, "open for writing");
  const int number = file.file.number();
  Status status;
  if (before && fchmod(number, before->st_mode & kPermissions) != 0) {
    status = Failure(path, "keep the mode");
  } else if (!WriteAll(number, pieces) || fsync(number) != 0) {
    status = Failure(path, "write");
  } else if (file.name.empty() && !GiveName(&file, target)) {
    status = Failure(path, "name what was written");
  } else if (!file.file.Close()) {
    status = Failure(path, "write");
  } else if (std::rename(file.name.c_str(), target.c_str()) != 0) {
    status = Failure(path, "replace");
  }
  if (!status.ok() && !file.name.empty()) unlink(file.name.c_str());
  return status;
}

Status WriteInto(Descriptor file, const std::string& path,
                 std::span<const std::string_view> pieces) {
  if (!file.is_open()) return Failure(path, "open for writing");
  return WriteAll(file.number(), pieces) && file.Close() ? Status() : Failure(path, "write");
}

Status Write(const std::string& path, std::span<const std::string_view> pieces) {
  const StatusOr<std::string> target = FollowLinks(path);
  if (!target.ok()) return target.status();
  if (const std::optional<int> own = OwnDescriptor(*target)) {
    std::fflush(stdout);  // what was printed before comes before
    return WriteInto(Descriptor(fcntl(*own, F_DUPFD_CLOEXEC, 0)), path, pieces);
  }
  struct stat before = {};
  const bool exists = stat(target->c_str(), &before) == 0;
  if (exists && S_ISDIR(before.st_mode)) return Failure(path, "write", EISDIR);
  if (exists && !S_ISREG(before.st_mode)) {
    return WriteInto(Descriptor(open(target->c_str(), O_WRONLY | O_CLOEXEC)), path, pieces);
  }
  return Replace(*target, path, exists ? &before : nullptr, pieces);
}

}  // namespace

Status WriteFileAtomically(const std::string& path, std::string_view content) {
  return Write(path, {&content, 1});
}

Status WriteFileAtomically(const std::string& path, const TextPieces& content) {
  const std::vector<std::string_view> pieces(content.begin(), content.end());
  return Write(path, pieces);
}

Status CheckOutputPath(const std::string& path) {
  const StatusOr<std::string> target = FollowLinks(path);
  if (!target.ok()) return target.status();
  if (OwnDescriptor(*target)) return Status();
  struct stat there = {};
  const bool exists = stat(target->c_str(), &there) == 0;
  if (exists && S_ISDIR(there.st_mode)) return Failure(path, "write", EISDIR);
  if (exists && access(target->c_str(), W_OK) != 0) return Failure(path, "write");
  if (exists && !S_ISREG(there.st_mode)) return Status();
  const std::string folder = FolderOf(*target);
  return access(folder.c_str(), W_OK | X_OK) == 0
             ? Status()
             : Failure(path, fmt::format("write to the folder {}", folder).c_str());
}

}  // namespace cirque

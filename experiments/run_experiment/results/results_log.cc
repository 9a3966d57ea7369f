#include "experiments/run_experiment/results/results_log.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <optional>
#include <sstream>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/atomic_file.h"

#include "experiments/common/records.h"
#include "experiments/run_experiment/config/file_content.h"

namespace cirque {
namespace {

constexpr int kAttempts = 20;
constexpr std::chrono::milliseconds kPause(50);
constexpr char kSequence[] = "sequence";
constexpr char kStarted[] = "/provenance/started";  ///< ISO 8601 in UTC: texts compare as times do

/// What orders two records with one key. A clock may be set back; it decides only between records
/// of before there were sequence numbers.
std::pair<std::int64_t, std::string> Order(const Record& record) {
  return {record.value(kSequence, std::int64_t{0}), TextAt(record, kStarted)};
}

namespace fs = std::filesystem;

class AppendOnlyFile {
 public:
  explicit AppendOnlyFile(const std::string& path)
      : descriptor_(open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {}
  AppendOnlyFile(const AppendOnlyFile&) = delete;
  AppendOnlyFile& operator=(const AppendOnlyFile&) = delete;
  ~AppendOnlyFile() {
    if (descriptor_ >= 0) close(descriptor_);
  }

  /// One write call, so that records of several processes do not mix. What was written in part is
  /// taken back; errno says why.
  bool Write(const std::string& text) const {
    struct stat before = {};
    if (descriptor_ < 0 || fstat(descriptor_, &before) != 0) return false;
    errno = ENOSPC;  // where less than all is written
    if (write(descriptor_, text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
        fdatasync(descriptor_) == 0) {
      return true;
    }
    const int error = errno;
    [[maybe_unused]] const int taken_back = ftruncate(descriptor_, before.st_size);
    errno = error;
    return false;
  }

 private:
  int descriptor_;
};

}  // namespace

StatusOr<FileLock> FileLock::Take(const std::string& path) {
  FileLock lock;
  lock.descriptor_ = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock.descriptor_ < 0) {
    return Status::InvalidInput(fmt::format("{}: cannot open: {}", path, std::strerror(errno)));
  }
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    if (flock(lock.descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return lock;
    std::this_thread::sleep_for(kPause);
  }
  return Status::InvalidInput(
      path +
      ": another run_experiment writes these results; wait for its end, or give each of them "
      "a part of the runs (--shard)");
}

FileLock::FileLock(FileLock&& other) noexcept { *this = std::move(other); }

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

StatusOr<ResultsLog> ResultsLog::Open(const std::string& folder, const Shard& shard) {
  const fs::path own = fs::path(folder) / shard.FileName();
  StatusOr<FileLock> lock = FileLock::Take((fs::path(folder) / ("." + shard.FileName() + ".lock")));
  if (!lock.ok()) return lock.status();
  ResultsLog log(own.string(), *std::move(lock));
  const std::vector<std::string> files = RecordFiles(folder);
  for (const std::string& file : files) {
    if (Status status = log.Read(file); !status.ok()) return status;
    log.has_shards_ = log.has_shards_ || fs::path(file).filename() != Shard().FileName();
  }
  return log;
}

Status ResultsLog::Read(const std::string& path) {
  const StatusOr<std::string> text = ReadWholeFile(path);
  if (!text.ok()) return text.status();
  if (path == path_) ends_torn_ = !text->empty() && text->back() != '\n';
  std::istringstream stream(*text);
  for (std::string line; std::getline(stream, line);) {
    if (line.empty()) continue;
    if (std::optional<Record> record = ParseRecord(line)) {
      Keep(*std::move(record));
    } else {
      ++skipped_lines_;
    }
  }
  return Status();
}

const Record* ResultsLog::Find(const std::string& key) const {
  const auto found = last_.find(key);
  return found == last_.end() ? nullptr : &records_[found->second];
}

Status ResultsLog::Append(Record record) {
  record[kSequence] = sequence_ + 1;
  // A torn last line is sealed first: it stays unreadable, the new one does not join it.
  const std::string line = fmt::format("{}{}\n", ends_torn_ ? "\n" : "", ToLine(record));
  if (!AppendOnlyFile(path_).Write(line)) {
    return {StatusCode::kResource,
            fmt::format("{}: cannot append: {}", path_, std::strerror(errno))};
  }
  ends_torn_ = false;
  Keep(std::move(record));
  return Status();
}

std::vector<Record> ResultsLog::Records() const {
  std::vector<Record> records;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    if (last_.at(records_[i]["key"].get<std::string>()) == i) records.push_back(records_[i]);
  }
  return records;
}

Status ResultsLog::Merge() {
  if (!has_shards_) return Status();
  std::string lines;
  for (const Record& record : Records()) lines += ToLine(record) + "\n";
  ends_torn_ = false;
  return WriteFileAtomically(path_, lines);
}

void ResultsLog::Keep(Record record) {
  const std::string key = record["key"];
  const auto last = last_.find(key);
  // Of two files the one read later need not be the later one.
  if (last != last_.end() && Order(records_[last->second]) > Order(record)) return;
  sequence_ = std::max(sequence_, Order(record).first);
  last_[key] = records_.size();
  records_.push_back(std::move(record));
}

}  // namespace cirque

#include "experiments/run_experiment/results_log.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>

#include "experiments/run_experiment/content_hash.h"

namespace cirque {
namespace {

bool IsRecord(const Record& json) {
  return json.is_object() && json.contains("key") && json["key"].is_string() &&
         json.contains("outcome") && json["outcome"].is_string();
}

class AppendOnlyFile {
 public:
  explicit AppendOnlyFile(const std::string& path)
      : descriptor_(open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {}
  AppendOnlyFile(const AppendOnlyFile&) = delete;
  AppendOnlyFile& operator=(const AppendOnlyFile&) = delete;
  ~AppendOnlyFile() {
    if (descriptor_ >= 0) close(descriptor_);
  }

  /// One write call, so that records of several processes do not mix.
  bool Write(const std::string& text) const {
    return descriptor_ >= 0 &&
           write(descriptor_, text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
           fdatasync(descriptor_) == 0;
  }

 private:
  int descriptor_;
};

}  // namespace

StatusOr<ResultsLog> ResultsLog::Open(const std::string& path) {
  ResultsLog log(path);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return log;
  const StatusOr<std::string> text = ReadWholeFile(path);
  if (!text.ok()) return text.status();
  log.ends_torn_ = !text->empty() && text->back() != '\n';
  std::istringstream stream(*text);
  for (std::string line; std::getline(stream, line);) {
    if (line.empty()) continue;
    Record record = Record::parse(line, nullptr, false);
    if (IsRecord(record)) {
      log.Keep(std::move(record));
    } else {
      ++log.skipped_lines_;
    }
  }
  return log;
}

const Record* ResultsLog::Find(const std::string& key) const {
  const auto found = last_.find(key);
  return found == last_.end() ? nullptr : &records_[found->second];
}

Status ResultsLog::Append(const Record& record) {
  // A torn last line is sealed first: it stays unreadable, the new one does not join it.
  const std::string line = fmt::format("{}{}\n", ends_torn_ ? "\n" : "", ToLine(record));
  if (!AppendOnlyFile(path_).Write(line)) {
    return Status::InvalidInput(fmt::format("{}: cannot append: {}", path_, std::strerror(errno)));
  }
  ends_torn_ = false;
  Keep(record);
  return Status();
}

std::vector<Record> ResultsLog::Records() const {
  std::vector<Record> records;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    if (last_.at(records_[i]["key"].get<std::string>()) == i) records.push_back(records_[i]);
  }
  return records;
}

void ResultsLog::Keep(Record record) {
  last_[record["key"].get<std::string>()] = records_.size();
  records_.push_back(std::move(record));
}

}  // namespace cirque

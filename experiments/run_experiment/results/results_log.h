#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cirque/core/status.h"

#include "experiments/run_experiment/config/planned_run.h"
#include "experiments/run_experiment/results/record.h"

namespace cirque {

/// Keeps other processes from a file for as long as this object, or its process, lives.
class FileLock {
 public:
  /// Waits a moment where another process holds the lock, then refuses. A file system without locks
  /// gives a lock that keeps nobody out.
  static StatusOr<FileLock> Take(const std::string& path);

  FileLock() = default;
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  ~FileLock();

 private:
  int descriptor_ = -1;
};

/// The records of a folder of results: append-only files, one JSON object a line, one file for each
/// shard and results.jsonl for all. Every file is read, only the own one is written, by one process
/// at a time. A record is on disk when Append returns, so that no end of the process loses one.
class ResultsLog {
 public:
  /// Reads what is there. Lines that are not whole records (the last one may be torn) are counted
  /// and otherwise passed over; of two records with one key the later holds.
  /// @pre the folder exists.
  static StatusOr<ResultsLog> Open(const std::string& folder, const Shard& shard);

  /// The last record with that key, or nullptr.
  const Record* Find(const std::string& key) const;

  /// Numbers the record by one more than all before (`sequence`): the later of two with one key is
  /// known without a clock. Error (kResource): it could not be written; the file is as it was.
  Status Append(Record record);

  /// Takes the shards' records, if there are any, into results.jsonl, which is replaced whole. The
  /// shards' files stay: they may be written at this moment. @pre opened for no shard.
  Status Merge();

  /// All records in the order of their last lines.
  std::vector<Record> Records() const;
  int skipped_lines() const { return skipped_lines_; }

 private:
  ResultsLog(std::string path, FileLock lock) : path_(std::move(path)), lock_(std::move(lock)) {}

  Status Read(const std::string& path);
  void Keep(Record record);

  std::string path_;
  FileLock lock_;
  std::vector<Record> records_;
  std::map<std::string, std::size_t> last_;  ///< key -> its position in records_
  int skipped_lines_ = 0;
  std::int64_t sequence_ = 0;  ///< the largest number of a record
  bool ends_torn_ = false;     ///< the own file
  bool has_shards_ = false;
};

}  // namespace cirque

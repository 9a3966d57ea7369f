#pragma once

#include <map>
#include <string>
#include <vector>

#include "cirque/core/status.h"

#include "experiments/run_experiment/record.h"

namespace cirque {

/// The append-only file of a folder's records, one JSON object a line. A record is on disk when
/// Append returns, so that no end of the process loses one.
class ResultsLog {
 public:
  /// Reads what is there. Lines that are not whole records (the last one may be torn) are counted
  /// and otherwise passed over; of two records with one key the later holds.
  static StatusOr<ResultsLog> Open(const std::string& path);

  /// The last record with that key, or nullptr.
  const Record* Find(const std::string& key) const;

  Status Append(const Record& record);

  /// All records in the order of their last lines.
  std::vector<Record> Records() const;
  int skipped_lines() const { return skipped_lines_; }

 private:
  explicit ResultsLog(std::string path) : path_(std::move(path)) {}

  void Keep(Record record);

  std::string path_;
  std::vector<Record> records_;
  std::map<std::string, std::size_t> last_;  ///< key -> its position in records_
  int skipped_lines_ = 0;
  bool ends_torn_ = false;
};

}  // namespace cirque

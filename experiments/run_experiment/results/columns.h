#pragma once

#include <string>
#include <vector>

#include "experiments/run_experiment/results/record.h"

namespace cirque {

/// One quantity of a record: where it stands in the record and how it is shown.
struct Column {
  std::string name;     ///< in results.csv
  std::string pointer;  ///< JSON pointer into the record
  std::string heading;  ///< in the table on the terminal; empty: not shown there
  std::string format;   ///< of a number there, by fmt; empty: as it is
};

/// The columns for these records: the fixed ones, then every further value and stage time that some
/// record has.
std::vector<Column> ColumnsFor(const std::vector<Record>& records);

/// The records as CSV (RFC 4180), numbers in shortest round-trip digits, null as nothing.
std::string ToCsv(const std::vector<Record>& records);

/// The records as an aligned table for people, columns that are empty throughout left out.
std::string ToTable(const std::vector<Record>& records);

}  // namespace cirque

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace cirque {

// The records of an experiment as its files hold them, one JSON object a line: what run_experiment
// writes and experiment_report reads.

/// The record of a line; nothing where it is torn or none: an object with texts `key` and `outcome`.
std::optional<nlohmann::json> ParseRecord(std::string_view line);

/// The files of records in a folder: results.jsonl, if there is one, then those of shards by name.
std::vector<std::string> RecordFiles(const std::string& folder);

/// The number at a JSON pointer, NaN where there is none.
double NumberAt(const nlohmann::json& record, const std::string& pointer);

/// The string at a JSON pointer, numbers and lists as JSON writes them; empty where there is none.
std::string TextAt(const nlohmann::json& record, const std::string& pointer);

/// A value as a field of a CSV (RFC 4180), numbers in shortest round-trip digits, null as nothing. A
/// text that a spreadsheet would take for a formula (=, +, -, @ first) has an apostrophe before it.
std::string CsvField(const nlohmann::json& value);

}  // namespace cirque

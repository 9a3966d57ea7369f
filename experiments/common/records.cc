#include "experiments/common/records.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>

#include "cirque/io/json_input.h"

namespace cirque {
namespace {

/// A string as it is, all else as JSON writes it; null as nothing.
std::string PlainText(const nlohmann::json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace

std::optional<nlohmann::json> ParseRecord(std::string_view line) {
  std::optional<nlohmann::json> record = ParseJson(line);
  const auto is_text = [&](const char* key) {
    return record->contains(key) && record->at(key).is_string();
  };
  const bool is_whole = record && record->is_object() && is_text("key") && is_text("outcome");
  return is_whole ? std::move(record) : std::nullopt;
}

std::vector<std::string> RecordFiles(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename();
    const bool is_shard = name.starts_with("results.shard-") && name.ends_with(".jsonl");
    if (is_shard || name == "results.jsonl") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());  // "results.j" before "results.s"
  return files;
}

double NumberAt(const nlohmann::json& record, const std::string& pointer) {
  const nlohmann::json::json_pointer place(pointer);
  if (!record.contains(place) || !record.at(place).is_number()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return record.at(place).get<double>();
}

std::string TextAt(const nlohmann::json& record, const std::string& pointer) {
  const nlohmann::json::json_pointer place(pointer);
  return record.contains(place) ? PlainText(record.at(place)) : "";
}

std::string CsvField(const nlohmann::json& value) {
  std::string text = PlainText(value);
  if (value.is_string() && text.find_first_of("=+-@\t\r") == 0) text = "'" + text;
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace cirque

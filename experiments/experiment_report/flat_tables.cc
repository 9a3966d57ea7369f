#include "experiments/experiment_report/flat_tables.h"

#include <map>

#include "cirque/core/text.h"

#include "experiments/common/records.h"

namespace cirque::experiment_report {
namespace {

using nlohmann::json;
using Row = std::map<std::string, json>;

std::string ColumnName(const std::string& outer, const std::string& inner) {
  if (outer.empty()) return inner;
  return inner == "name" ? outer : outer + "_" + inner;
}

void Flatten(const std::string& outer, const json& value, Row* row) {
  if (!value.is_object()) {
    (*row)[outer] = value.is_array() ? json(value.dump()) : value;
    return;
  }
  for (const auto& [inner, child] : value.items()) {
    if (outer.empty() && inner == "history") continue;
    // The measures keep their own names; one that is a column already keeps its group's too.
    const bool bare = outer == "values" && !row->contains(inner);
    Flatten(bare ? inner : ColumnName(outer, inner), child, row);
  }
}

/// The columns of all rows: those people look for first, then the others by name.
std::vector<std::string> Columns(const std::vector<Row>& rows) {
  std::vector<std::string> columns = {"mesh",    "mesh_triangles", "method",       "repeat",
                                      "outcome", "message",        "seconds_total"};
  std::map<std::string, int> others;
  for (const Row& row : rows) {
    for (const auto& [name, value] : row) others[name] = 1;
  }
  for (const std::string& name : columns) others.erase(name);
  for (const auto& [name, unused] : others) columns.push_back(name);
  return columns;
}

void AddHistory(const Run& run, const std::string& stage, const std::string& strategy,
                FlatTable* table) {
  const json::json_pointer pointer("/history/" + stage);
  if (!run.record.contains(pointer) || !run.record.at(pointer).is_array()) return;
  int iteration = 0;
  for (const json& gradient : run.record.at(pointer)) {
    table->rows.push_back({run.key, run.mesh, run.method, stage, strategy, iteration++,
                           gradient.is_number() ? gradient : json()});
  }
}

}  // namespace

std::string FlatTable::Csv() const {
  std::vector<std::string> fields;
  for (const std::string& column : columns) fields.push_back(CsvField(column));
  std::string csv = Join(fields, ",") + "\n";
  for (const std::vector<json>& row : rows) {
    fields.clear();
    for (const json& value : row) fields.push_back(CsvField(value));
    csv += Join(fields, ",") + "\n";
  }
  return csv;
}

std::string FlatTable::Json() const {
  std::vector<std::string> lines;
  for (const std::vector<json>& row : rows) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < columns.size(); ++i) object[columns[i]] = row[i];
    lines.push_back(object.dump(-1, ' ', false, json::error_handler_t::replace));
  }
  return "[" + Join(lines, ",\n ") + "]\n";
}

FlatTable RunTable(const std::vector<Run>& runs) {
  std::vector<Row> flat;
  for (const Run& run : runs) Flatten("", run.record, &flat.emplace_back());
  FlatTable table{Columns(flat), {}};
  for (const Row& row : flat) {
    std::vector<json>& values = table.rows.emplace_back();
    for (const std::string& column : table.columns) {
      values.push_back(row.contains(column) ? row.at(column) : json());
    }
  }
  return table;
}

FlatTable ConvergenceTable(const std::vector<Run>& runs) {
  FlatTable table{{"key", "mesh", "method", "stage", "strategy", "iteration", "gradient"}, {}};
  for (const Run& run : runs) {
    AddHistory(run, "angles", run.angle_solver, &table);
    AddHistory(run, "radii", run.radii_solver, &table);
  }
  return table;
}

}  // namespace cirque::experiment_report

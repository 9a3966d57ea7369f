#include "experiments/run_experiment/results/columns.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/pipeline/options.h"

#include "experiments/common/records.h"

namespace cirque {
namespace {

std::vector<Column> MakeFixedColumns() {
  std::vector<Column> columns = {
      {"key", "/key", "", ""},
      {"mesh", "/mesh/name", "mesh", ""},
      {"mesh_source", "/mesh/source", "", ""},
      {"mesh_hash", "/mesh/hash", "", ""},
      {"vertices", "/mesh/vertices", "", ""},
      {"triangles", "/mesh/triangles", "triangles", ""},
      {"method", "/method/name", "method", ""},
      {"domain", "/method/domain", "", ""},
      {"energy", "/method/energy", "", ""},
      {"energy_solver", "/method/energy_solver", "", ""},
      {"energy_start", "/method/energy_start", "", ""},
      {"peer", "/method/peer", "", ""},
  };
  for (const std::string& option : ParameterizeOptionTable().Names()) {
    columns.push_back({option, "/method/" + option, "", ""});
  }
  const std::vector<Column> rest = {
      {"repeat", "/repeat", "", ""},
      {"outcome", "/outcome", "outcome", ""},
      {"message", "/message", "", ""},
      {"seconds_total", "/seconds/total", "time [s]", "{:.2f}"},
      {"cpu_seconds", "/cpu_seconds", "", ""},
      {"map_cpu_seconds", "/map_cpu_seconds", "", ""},
      {"reference_seconds", "/reference/seconds", "", ""},
      {"reference_cpu_seconds", "/reference/cpu_seconds", "", ""},
      {"peak_memory_mib", "/peak_memory_mib", "", ""},
      {"overlap", "/overlap", "overlap", ""},
      {"smallest_angle", "/values/smallest_angle", "min angle", "{:.2e}"},
      {"smallest_theta", "/values/smallest_theta", "min theta", "{:.2e}"},
      {"radii_gradient", "/values/radii_gradient", "gradient", "{:.1e}"},
      {"angle_gap", "/values/angle_gap", "angle gap", "{:.1e}"},
      {"radii_gap", "/values/radii_gap", "radii gap", "{:.1e}"},
      {"flipped_triangles", "/values/flipped_triangles", "flips", "{:.0f}"},
      {"quasi_conformal_mean", "/values/quasi_conformal_mean", "qc mean", "{:.4f}"},
      {"quasi_conformal_max", "/values/quasi_conformal_max", "qc max", "{:.3f}"},
      {"edge_length", "/values/edge_length", "edge", "{:.4f}"},
      {"known_map_rms_error", "/values/known_map_rms_error", "map rms", "{:.2e}"},
      {"known_map_max_error", "/values/known_map_max_error", "map max", "{:.2e}"},
      {"energy_iterations", "/values/energy_iterations", "iterations", "{:.0f}"},
      {"energy_factorizations", "/values/energy_factorizations", "factorizations", "{:.0f}"},
      {"energy_gradient", "/values/energy_gradient", "gradient", "{:.1e}"},
      {"energy_difference", "/values/energy_difference", "difference", "{:.1e}"},
      {"map", "/map", "", ""},
      {"started", "/provenance/started", "", ""},
      {"config", "/provenance/config", "", ""},
      {"config_hash", "/provenance/config_hash", "", ""},
      {"version", "/provenance/version", "", ""},
      {"code", "/provenance/code", "", ""},
      {"build", "/provenance/build", "", ""},
      {"cpu", "/provenance/cpu", "", ""},
      {"blas_threads", "/provenance/blas_threads", "", ""},
      {"threads", "/provenance/threads", "", ""},
  };
  columns.insert(columns.end(), rest.begin(), rest.end());
  return columns;
}

/// The table of columns. `values` holds what certificates measure, by their names.
const std::vector<Column>& FixedColumns() {
  static const std::vector<Column> kColumns = MakeFixedColumns();
  return kColumns;
}

nlohmann::json ValueAt(const Record& record, const Column& column) {
  const nlohmann::json::json_pointer pointer(column.pointer);
  return record.contains(pointer) ? record.at(pointer) : nlohmann::json();
}

std::string ShownText(const nlohmann::json& value, const Column& column) {
  if (value.is_number() && !column.format.empty()) {
    return fmt::format(fmt::runtime(column.format), value.get<double>());
  }
  if (value.is_null()) return "-";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// A column of text as the terminal shows it, its heading first.
std::vector<std::string> ShownColumn(const std::vector<Record>& records, const Column& column) {
  std::vector<std::string> texts = {column.heading};
  for (const Record& record : records) texts.push_back(ShownText(ValueAt(record, column), column));
  return texts;
}

std::string PointerTo(const std::string& group, const std::string& name) {
  return (nlohmann::json::json_pointer("/" + group) / name).to_string();
}

/// The measures that the run was asked for; none where the file has something else.
std::vector<std::string> MeasuresOf(const Record& record) {
  std::vector<std::string> names;
  if (!record.contains("measures")) return names;
  for (const nlohmann::json& name : record["measures"]) {
    if (name.is_string()) names.push_back(name);
  }
  return names;
}

/// The fixed columns and those of the measures that the runs were asked for.
std::vector<Column> TableColumns(const std::vector<Record>& records) {
  std::vector<Column> columns = FixedColumns();
  std::set<std::string> shown;
  for (const Column& column : columns) {
    if (!column.heading.empty()) shown.insert(column.pointer);
  }
  for (const Record& record : records) {
    for (const std::string& name : MeasuresOf(record)) {
      const std::string pointer = PointerTo("values", name);
      if (shown.insert(pointer).second) columns.push_back({name, pointer, name, "{:.4g}"});
    }
  }
  return columns;
}

bool IsEmpty(const std::vector<std::string>& shown) {
  return std::all_of(shown.begin() + 1, shown.end(), [](const auto& text) { return text == "-"; });
}

}  // namespace

std::vector<Column> ColumnsFor(const std::vector<Record>& records) {
  std::vector<Column> columns = FixedColumns();
  std::set<std::string> pointers;
  for (const Column& column : columns) pointers.insert(column.pointer);
  for (const std::string group : {"values", "seconds"}) {
    std::set<std::string> names;
    for (const Record& record : records) {
      if (!record.contains(group) || !record[group].is_object()) continue;
      for (const auto& [name, value] : record[group].items()) names.insert(name);
    }
    for (const std::string& name : names) {
      const std::string pointer = PointerTo(group, name);
      if (!pointers.insert(pointer).second) continue;
      columns.push_back({group == "seconds" ? "seconds_" + name : name, pointer, "", ""});
    }
  }
  return columns;
}

std::string ToCsv(const std::vector<Record>& records) {
  const std::vector<Column> columns = ColumnsFor(records);
  std::vector<std::string> cells;
  for (const Column& column : columns) cells.push_back(CsvField(column.name));
  std::string csv = Join(cells, ",") + "\n";
  for (const Record& record : records) {
    cells.clear();
    for (const Column& column : columns) {
      cells.push_back(CsvField(ValueAt(record, column)));
    }
    csv += Join(cells, ",") + "\n";
  }
  return csv;
}

std::string ToTable(const std::vector<Record>& records) {
  std::vector<std::string> lines(records.size() + 1);
  for (const Column& column : TableColumns(records)) {
    if (column.heading.empty()) continue;
    const std::vector<std::string> shown = ShownColumn(records, column);
    if (IsEmpty(shown)) continue;
    std::size_t width = 0;
    for (const std::string& text : shown) width = std::max(width, text.size());
    const bool is_number = !records.empty() && ValueAt(records[0], column).is_number();
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const std::string gap = lines[i].empty() ? "" : "  ";
      lines[i] +=
          gap + (is_number || !column.format.empty() ? fmt::format("{:>{}}", shown[i], width)
                                                     : fmt::format("{:<{}}", shown[i], width));
    }
  }
  return Join(lines, "\n") + "\n";
}

}  // namespace cirque

#include "experiments/run_experiment/config/quantities.h"

#include <algorithm>
#include <set>

#include <glog/logging.h>

#include "cirque/metrics/measure_map.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/options.h"

#include "experiments/run_experiment/config/energy_figures.h"

namespace cirque {
namespace {

/// What every run may tell, whatever the method and the measures.
const std::vector<Quantity>& OwnQuantities() {
  static const std::vector<Quantity> kTable = {
      {"triangles", "/mesh/triangles", "triangles"},
      {"vertices", "/mesh/vertices", "vertices"},
      {"repeat", "/repeat", "repeat"},
      {"seconds", "/seconds/total", "time [s]"},
      {"seconds_triangulation", "/seconds/triangulation", "time of the flips [s]"},
      {"seconds_angles", "/seconds/angles", "time of the angle fit [s]"},
      {"seconds_radii", "/seconds/radii", "time of the log radii [s]"},
      {"seconds_layout", "/seconds/layout", "time of the layout [s]"},
      {"cpu_seconds", "/cpu_seconds", "CPU time [s]"},
      {"map_cpu_seconds", "/map_cpu_seconds", "CPU time without reading the mesh [s]"},
      {"reference_cpu_seconds", "/reference/cpu_seconds", "reference factorization [CPU s]"},
      {"peak_memory_mib", "/peak_memory_mib", "peak memory [MiB]"},
      {"edge_length", "/values/edge_length", "edge length over diameter"},
      {"known_map_rms_error", "/values/known_map_rms_error", "rms distance from the known map"},
      {"known_map_max_error", "/values/known_map_max_error", "distance from the known map"},
      {"refined_map_rms_error", "/values/refined_map_rms_error",
       "rms distance from the refined surface's map"},
      {"refined_map_max_error", "/values/refined_map_max_error",
       "distance from the refined surface's map"},
  };
  return kTable;
}

/// Those of runs that minimise an energy.
std::vector<Quantity> EnergyQuantities() {
  std::vector<Quantity> table;
  for (const EnergyFigure& figure : EnergyFigures()) {
    table.push_back({figure.name, "/values/" + figure.name, figure.label});
  }
  return table;
}

/// A name as people write it.
std::string Spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::vector<Quantity> MakeQuantities() {
  std::vector<Quantity> table = OwnQuantities();
  const std::vector<Quantity> of_energies = EnergyQuantities();
  table.insert(table.end(), of_energies.begin(), of_energies.end());
  // What runs and methods call so themselves comes first.
  std::set<std::string> names;
  for (const Quantity& quantity : table) names.insert(quantity.name);
  for (const OptionInfo& option : ParameterizeOptionTable().Infos()) {
    if (IsNumeric(option.kind)) names.insert(option.name);
  }
  for (const CertificateField& field : CertificateFields()) {
    if (names.insert(field.name).second) {
      table.push_back({field.name, "/values/" + field.name, field.Label()});
    }
  }
  for (const std::string& figure : FigureNames()) {
    if (!names.insert(figure).second) continue;
    table.push_back({figure, "/values/" + figure, Spaced(figure)});
  }
  for (const OptionInfo& option : ParameterizeOptionTable().Infos()) {
    if (IsNumeric(option.kind)) {
      table.push_back({option.name, "/method/" + option.name, Spaced(option.name)});
    }
  }
  return table;
}

std::vector<Quantity> MakeGroups() {
  std::vector<Quantity> table = {{"mesh", "/mesh/name", "mesh"},
                                 {"mesh_family", "/mesh/family", "mesh"},
                                 {"method", "/method/name", "method"},
                                 {"domain", "/method/domain", "domain"},
                                 {"overlap", "/overlap", "overlap"},
                                 {"energy", "/method/energy", "energy"},
                                 {"energy_solver", "/method/energy_solver", "strategy"},
                                 {"energy_start", "/method/energy_start", "start"}};
  for (const std::string& option : ParameterizeOptionTable().Names()) {
    table.push_back({option, "/method/" + option, Spaced(option)});
  }
  return table;
}

std::vector<std::string> NamesOf(const std::vector<Quantity>& table) {
  std::vector<std::string> names;
  for (const Quantity& quantity : table) names.push_back(quantity.name);
  return names;
}

}  // namespace

const std::vector<Quantity>& Quantities() {
  static const std::vector<Quantity> table = MakeQuantities();
  return table;
}

std::vector<std::string> QuantityNames() { return NamesOf(Quantities()); }

const std::vector<Quantity>& Groups() {
  static const std::vector<Quantity> table = MakeGroups();
  return table;
}

std::vector<std::string> GroupNames() { return NamesOf(Groups()); }

const Quantity& FindQuantity(const std::vector<Quantity>& table, const std::string& name) {
  const auto match = std::find_if(table.begin(), table.end(),
                                  [&](const Quantity& quantity) { return quantity.name == name; });
  CHECK(match != table.end()) << name;
  return *match;
}

}  // namespace cirque

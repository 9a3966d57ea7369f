#include "experiments/run_experiment/config/cells.h"

#include <fnmatch.h>

#include <fmt/format.h>

namespace cirque {

std::string MeshSpec::Source() const {
  const std::string fineness =
      subdivisions == 0 ? "" : fmt::format(" subdivisions={}", subdivisions);
  if (!file.empty()) return file + fineness;
  if (!archive.empty()) return archive + ":" + member + fineness;
  return fmt::format("{} triangles={} seed={}{}{}", generator, generator_options.triangles,
                     generator_options.seed, known_boundary ? " boundary=known_map" : "", fineness);
}

std::string Cell::Label() const {
  const std::string label = mesh.name + "/" + method.name;
  return repeat == 0 ? label : fmt::format("{}#{}", label, repeat + 1);
}

std::vector<Cell> MakeCells(const std::vector<MeshSpec>& meshes,
                            const std::vector<MethodSpec>& methods, int repeats) {
  std::vector<Cell> cells;
  for (const MeshSpec& mesh : meshes) {
    for (const MethodSpec& method : methods) {
      for (int repeat = 0; repeat < repeats; ++repeat) cells.push_back({mesh, method, repeat});
    }
  }
  return cells;
}

bool MatchesPattern(const Cell& cell, const std::string& pattern) {
  for (const std::string& label : {cell.Label(), cell.mesh.name + "/" + cell.method.name}) {
    if (fnmatch(pattern.c_str(), label.c_str(), 0) == 0) return true;
  }
  return false;
}

std::vector<Cell> SelectCells(const std::vector<Cell>& cells, const std::string& text) {
  const bool is_pattern = text.find_first_of("*?[") != std::string::npos;
  std::vector<Cell> selected;
  for (const Cell& cell : cells) {
    if (is_pattern ? MatchesPattern(cell, text) : cell.Label().find(text) != std::string::npos) {
      selected.push_back(cell);
    }
  }
  return selected;
}

}  // namespace cirque

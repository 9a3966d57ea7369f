#pragma once

#include <string>
#include <vector>

#include "cirque/mesh/generators.h"
#include "cirque/pipeline/parameterize.h"

namespace cirque {

/// Where a surface comes from: a file, a member of an archive, or a generator.
struct MeshSpec {
  std::string name;  ///< unique within a config
  std::string file;  ///< absolute; empty unless the source is a file
  std::string archive, member;
  std::string generator;
  GeneratorOptions generator_options;
  bool known_boundary = false;  ///< boundary angles as in the generator's known conformal map

  /// The source in one line, as records show it.
  std::string Source() const;
};

struct MethodSpec {
  std::string name;  ///< unique within a config
  ParameterizeOptions options;
};

/// One run: a surface, a method, and which repeat of them this is (from 0).
struct Cell {
  MeshSpec mesh;
  MethodSpec method;
  int repeat = 0;
  std::vector<std::string> measures = {};  ///< further figures of the map, as the config lists them

  /// "mesh/method", and "#2" for a second repeat: what `--only` searches and `--dry_run` lists.
  std::string Label() const;
};

/// Every mesh with every method and repeat, mesh by mesh.
std::vector<Cell> MakeCells(const std::vector<MeshSpec>& meshes,
                            const std::vector<MethodSpec>& methods, int repeats);

/// The cells whose label contains `text`.
std::vector<Cell> SelectCells(const std::vector<Cell>& cells, const std::string& text);

}  // namespace cirque

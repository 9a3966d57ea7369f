#pragma once

#include <string>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/domains/map_options.h"
#include "cirque/generators/generators.h"
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
  std::string family = {};      ///< the name before triangles, seed and subdivisions are added
  int subdivisions = 0;         ///< how often it is subdivided
  std::string subdivision = "midpoint";  ///< by which of SubdivisionSchemes()
  Index decimate = 0;  ///< before that, edges collapsed until so many triangles are left; 0: none
  std::string repair = MeshOptions().repair;  ///< before all that, as of MeshOptions

  /// The source in one line, as records show it.
  std::string Source() const;
};

/// An energy that is minimised by itself, in place of a map that is made.
struct EnergyTrial {
  std::string energy;             ///< a name of Energies(); empty: a map is made
  std::string solver = "newton";  ///< NAME or NAME:KEY=VALUE,... of SolverStrategies()
  std::string start = "own";      ///< a name of EnergyStarts()

  bool IsAskedFor() const { return !energy.empty(); }
};

struct MethodSpec {
  std::string name;  ///< unique within a config
  ParameterizeOptions options;
  std::string domain = "plane";  ///< a name of Domains()
  EnergyTrial trial = {};        ///< of the options only epsilon counts beside it
  /// Another program that makes the map: its path and arguments, of which {in} and {out} stand for
  /// files. Empty: this one.
  std::vector<std::string> peer = {};

  bool MakesMapItself() const { return !trial.IsAskedFor() && peer.empty(); }
};

/// What a run may take before it is ended; 0: anything.
struct RunLimits {
  double seconds = 0;     ///< of wall time
  double memory_mib = 0;  ///< resident
};

/// One run: a surface, a method, and which repeat of them this is (from 0).
struct PlannedRun {
  MeshSpec mesh;
  MethodSpec method;
  int repeat = 0;
  std::vector<std::string> measures = {};  ///< further figures of the map, as the config lists them
  RunLimits limits = {};
  bool keep_map = false;   ///< whether the mesh with its map is written to maps/
  bool reference = false;  ///< whether the reference factorization is timed beside the run
  /// Whether the map is also compared with that of the surface subdivided once more.
  bool against_refined = false;

  /// "mesh/method", and "#2" for a second repeat: what `--only` searches and `--dry_run` lists.
  std::string Label() const;
};

/// Every mesh with every method and repeat, mesh by mesh.
std::vector<PlannedRun> PlanRuns(const std::vector<MeshSpec>& meshes,
                                 const std::vector<MethodSpec>& methods, int repeats);

/// Whether the run's label, with or without its "#2", is the pattern, a shell's: * ? [...].
bool MatchesPattern(const PlannedRun& run, const std::string& pattern);

/// The runs whose label contains `text`; where that is a pattern, those whose label is it.
std::vector<PlannedRun> SelectRuns(const std::vector<PlannedRun>& runs, const std::string& text);

/// One of several parts of an experiment that are run apart, on machines that share the folder.
struct Shard {
  int index = 1, count = 1;  ///< from 1 to count

  bool IsWhole() const { return count == 1; }
  /// Where the part's records are kept: results.jsonl, or results.shard-2-of-8.jsonl.
  std::string FileName() const;
};

/// Reads "2/8".
StatusOr<Shard> ParseShard(const std::string& text);

/// The shard's runs in their order. Together the shards have every run once; which run goes
/// where hangs on its name alone, so that slow methods and large meshes are spread.
std::vector<PlannedRun> SelectShard(const std::vector<PlannedRun>& runs, const Shard& shard);

}  // namespace cirque

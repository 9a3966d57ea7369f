#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "cirque/core/status.h"

#include "experiments/run_experiment/config/planned_run.h"
#include "experiments/run_experiment/run/carry_out.h"
#include "experiments/run_experiment/run/mesh_files.h"

namespace cirque {

/// Outcomes beside those of StatusCode and of carry_out.h: the run threw, its process ended without a
/// record, or was killed by somebody else (a user, the system short of memory).
inline constexpr char kException[] = "exception", kCrash[] = "crash", kKilled[] = "killed";

/// One run as one self-contained object of results.jsonl.
using Record = nlohmann::json;

/// The run's method with every option, as records and keys hold it.
nlohmann::json MethodJson(const MethodSpec& method);

/// Names a record by all that determines it: the run, content of the mesh, method as of
/// MethodByContent, code as of RunCode.
std::string RunKey(const PlannedRun& run, const std::string& mesh_hash,
                   const nlohmann::json& method, const std::string& code_version);

/// Numbers that a run did not come to are null.
Record MakeRecord(const std::string& key, const PlannedRun& run, const LocatedMesh& mesh,
                  const RunResult& result, const nlohmann::json& provenance);

/// One line, whatever bytes the messages hold.
std::string ToLine(const Record& record);

std::string OutcomeOf(const Record& record);

/// Whether the run need not be made again: it came to its own end (was not cancelled or killed, and
/// the machine did not fail it), was not ended by a lower limit than the run's, and left its map
/// where the run keeps it.
bool IsFinished(const Record& record, const PlannedRun& run);

/// Whether the run ended as it should: in a map or a minimum, in an infeasibility certificate, or with
/// a strategy that has no such form of the energy.
bool IsSettled(const Record& record);

/// A method with every option, files (of edge costs, of cones, programs) by the hash of what they
/// hold instead of by name. Error (invalid input): such a file cannot be read.
StatusOr<nlohmann::json> MethodByContent(const MethodSpec& method);

}  // namespace cirque

#pragma once

#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "cirque/core/status.h"

#include "experiments/run_experiment/config/config_text.h"
#include "experiments/run_experiment/config/planned_run.h"
#include "experiments/run_experiment/config/schema_field.h"

namespace cirque {

/// The key `peer` and those of its entries.
Schema PeerFields();

/// The words of a command line: blanks divide, quotes (' or ") hold together. Error: a quote that is
/// not closed, no word at all.
StatusOr<std::vector<std::string>> SplitCommand(const std::string& command);

/// The other programs of a config as methods, which the schema has let pass. A program with a slash
/// in its name starts at `root`; others lie beside this program or in PATH. Reported: a command
/// without {in} or {out}; a program that is not there, unless it is optional, which is a note.
std::vector<MethodSpec> ReadPeers(const YAML::Node& value, const std::string& root,
                                  Diagnostics* problems, std::vector<std::string>* notes);

}  // namespace cirque

#pragma once

#include <string>
#include <vector>

#include "cirque/core/registry.h"
#include "cirque/core/status.h"

#include "experiments/run_experiment/config/planned_run.h"

namespace cirque {

/// A path of a config: relative ones start at `root`, and "$MESHES/" is the folder that the
/// environment's CIRQUE_MESHES names, or else meshes/ there.
std::string AbsolutePath(const std::string& root, const std::string& path);

/// Collections of meshes by name: the archives and folders that make them up.
///
///   libcgal-demo    the meshes of Debian's package of that name
const Registry<std::vector<std::string>>& Corpora();

/// The files that match the pattern, sorted; a path without wildcards matches itself if it exists.
/// Sources only: names come from NameMeshes.
std::vector<MeshSpec> MatchFiles(const std::string& pattern);

/// All mesh files of a corpus, by their extensions, sorted: of one of Corpora(), of a folder and
/// those in it, of an archive, or those that a text file lists, a path on every line (relative to
/// that file; lines that begin with # are comments). Errors: there is no such thing, or no mesh in
/// it.
StatusOr<std::vector<MeshSpec>> MeshesOfCorpus(const std::string& root, const std::string& corpus);

/// Calls each after its file, without folder and extension. Files that are told apart by their
/// folders only get those of their folders that do it: a/knot.off and b/knot.off are a-knot and
/// b-knot; where these do not, extensions and archives do.
void NameMeshes(std::vector<MeshSpec>* meshes);

}  // namespace cirque

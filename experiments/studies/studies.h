#pragma once

#include <string>
#include <vector>

#include "cirque/core/status.h"

namespace cirque {

/// How a study was called.
struct StudyCall {
  std::vector<std::string> arguments;  ///< the words that are no flags
  std::string command;                 ///< as it was written, for the page to say how it was made
};

/// One subcommand of the program `studies`.
struct Study {
  std::string name, usage, what;
  std::string source;  ///< a part of the path of the file with its flags
  Status (*run)(const StudyCall& call);
};

/// All of them, in the order of the help text.
const std::vector<Study>& Studies();

/// The flag --output, which all have.
const std::string& OutputFile();

/// Writes the text to --output, or prints it where there is none.
Status Deliver(const std::string& text);

Status NoArguments(const StudyCall& call);

/// Minimises every energy of each mesh by every strategy.
Status RunStrategies(const StudyCall& call);

/// Centres crowded points on the sphere by three Newton methods.
Status RunLorentz(const StudyCall& call);

/// Holds maps to the unit disk and to rectangles against known ones.
Status RunDiskAccuracy(const StudyCall& call);

/// Maps surfaces, and again renumbered, turned and scaled.
Status RunInvariance(const StudyCall& call);

/// Maps random small surfaces and judges what comes out.
Status RunRandomSurfaces(const StudyCall& call);

/// Maps random small surfaces with random cones in several ways and counts what is left.
Status RunAnyCones(const StudyCall& call);

/// Moves textures from one map of a mesh to another.
Status RunMovedTexture(const StudyCall& call);

/// Holds maps of least symmetric Dirichlet energy against those of another method.
Status RunSlim(const StudyCall& call);

/// Times the factorization that every linear conformal map needs.
Status RunReferenceFactorization(const StudyCall& call);

/// Does only what every circle pattern must.
Status RunLowerBound(const StudyCall& call);

}  // namespace cirque

#pragma once

#include <ostream>
#include <string>

#include "cirque/core/status.h"
#include "cirque/pipeline/parameterize.h"

namespace cirque {

/// What the program was asked to do.
struct CirclePatternsJob {
  std::string input, output;
  std::string certificate;  ///< where to write it; empty: beside the output
  ParameterizeOptions options;
};

/// "DIR/NAME.certificate.json" for an output "DIR/NAME.EXT".
std::string CertificatePath(const CirclePatternsJob& job);

/// Reads, checks, flattens and writes, telling `report` what it finds. The output is written only
/// for a map that the checks accept; the certificate whenever the mesh could be read and was fit to
/// be parameterized; neither when `control` cancels.
Status RunCirclePatterns(const CirclePatternsJob& job, const SolveControl& control,
                         std::ostream& report);

}  // namespace cirque

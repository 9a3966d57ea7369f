#pragma once

#include <ostream>
#include <string>

#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/pipeline/parameterize.h"

#include "experiments/circle_patterns/job.h"

namespace cirque {

/// "DIR/NAME.certificate.json" for an output "DIR/NAME.EXT".
std::string CertificatePath(const CirclePatternsJob& job);

/// Where a proof of infeasibility leaves the faces and vertices that carry it: the certificate's
/// path without ".certificate.json"; ".infeasible.csv" and ".infeasible.ply" are added.
std::string CarrierStem(const CirclePatternsJob& job);

/// Writes the certificate, with the memory and the time of the process until now, and the carriers
/// of its proof if it holds one. Returns `status`, or what kept it from writing.
Status WriteCertificate(const CirclePatternsJob& job, const Surface& surface, const Timer& timer,
                        Certificate* certificate, const Status& status, std::ostream& report);

/// Reads, checks, flattens and writes, telling `report` what it finds. The output is written only
/// for a map that the checks accept; the certificate whenever the mesh could be read and was fit to
/// be parameterized, beside it the carriers of a proof that there is no map; none of them when
/// `control` cancels.
Status RunCirclePatterns(const CirclePatternsJob& job, const SolveControl& control,
                         std::ostream& report);

/// The same for an intrinsic metric from a CON file. The output's points are the map's own: (u, v,
/// 0) for every vertex of the surface opened along the cut.
Status RunOnMetric(const CirclePatternsJob& job, const SolveControl& control, std::ostream& report);

}  // namespace cirque

#pragma once

#include <ostream>
#include <string>

#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/domains/domain.h"
#include "cirque/io/io.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/certificate.h"

#include "experiments/circle_patterns/job.h"

namespace cirque {

/// The evidence in a few lines for people.
std::string Summary(const Certificate& certificate);

/// Refuses outputs before anything is solved for them: names whose format cannot hold a map, paths
/// that cannot be written to, and files that are inputs (by whatever name or link) unless the job
/// allows that.
Status CheckOutputs(const CirclePatternsJob& job);

/// What was read, and the surface that has a map.
struct Input {
  const MeshFile& file;
  const Surface& surface;
  const Surface& solved;  ///< with the fill of its holes
};

/// Writes the map of the input's own triangles: with UV the mesh as it was with texture, or its
/// points on the sphere (vertices of no face at (0, 0, 0)), as a .ply beside those that it had,
/// with the distortion of every face; then the flat metric, measures and texture of latitude and
/// longitude as far as the job asks for them.
Status WriteOutputs(const CirclePatternsJob& job, const Input& input, std::ostream& report,
                    SurfaceMap* map);

/// Writes the job's CON file: the metric where it was solved or, flipped back, as near to the
/// input's triangulation as it allows; the edges that stay are told and counted in the certificate.
Status WriteFlatMetric(const CirclePatternsJob& job, std::ostream& report, Parameterization* map);

/// What a map to the plane was measured on: the triangles written and their points.
struct MeasuredMesh {
  const Triangulation& triangulation;
  const EdgeLengths& lengths;
  const std::vector<Eigen::Vector3d>& position;
  const std::vector<Index>& corner;
};

/// The map's measures in the files that the job asks for, colours on the mesh given.
Status WriteMeasures(const CirclePatternsJob& job, const MeasuredMesh& mesh, const CornerUv& uv,
                     std::ostream& report);

/// Where the certificate goes if it is written: as the job says, else "DIR/NAME.certificate.json" for
/// an output "DIR/NAME.EXT"; nothing beside a device or stream.
std::string CertificatePath(const CirclePatternsJob& job);

/// Where an infeasibility certificate leaves the faces and vertices that carry it: the certificate's
/// path without ".certificate.json"; ".infeasible.csv" and ".infeasible.ply" are added.
std::string CarrierStem(const CirclePatternsJob& job);

/// Writes the certificate, with the memory and the time of the process until now, and the carriers
/// of its infeasibility certificate if it holds one; without being asked for it, only of an outcome
/// that is not ok. Returns `status`, or what kept it from writing.
Status WriteCertificate(const CirclePatternsJob& job, const Surface& surface, const Timer& timer,
                        Certificate* certificate, const Status& status, std::ostream& report);

}  // namespace cirque

#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "cirque/core/status.h"
#include "cirque/core/types.h"
#include "cirque/domains/map_mesh.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/pipeline/certificate.h"

#include "experiments/common/reference_factorization.h"
#include "experiments/run_experiment/config/planned_run.h"

namespace cirque {

/// What a run leaves behind. The certificate's outcome and message are always set.
struct RunResult {
  Index vertices = 0, triangles = 0;  ///< of the mesh; 0 when it could not be read
  Certificate certificate;
  /// Figures beside those of the certificate: the measures asked for, errors against a known map.
  std::map<std::string, double> figures = {};
  /// The mesh with its map, where the run keeps it and there is one; of a map to the sphere the
  /// mesh with its points there.
  PolygonSoup map = {};
  double seconds = 0;          ///< wall time, the reference left out; 0: until this is returned
  double cpu_seconds = 0;      ///< of this process, the reference left out
  double map_cpu_seconds = 0;  ///< the part of it after reading and making the surface
  double peak_memory_mib = 0;  ///< of this process until the run's end; 0: not known
  ReferenceFactorization reference = {};  ///< the fastest of three, where the run asks for it
};

/// Carries out one run; `mesh_path` is the mesh's file, empty for a generated mesh.
using RunFunction = std::function<RunResult(const PlannedRun& run, const std::string& mesh_path)>;

/// The real one: read or generate, repair and take apart, subdivide, map to the domain, measure; then the
/// reference.
RunResult ParameterizeRun(const PlannedRun& run, const std::string& mesh_path);

/// Maps the mesh, all of its components, to the run's domain with the run's method and measures the
/// map: certificate and, where the run keeps it, map of the result. `soup` is what was taken apart.
/// Stages that the certificate has timed already keep their times.
Status MapRun(const PlannedRun& run, const PolygonSoup& soup,
              const std::shared_ptr<const MeshParts>& parts, RunResult* result);

}  // namespace cirque

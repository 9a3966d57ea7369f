#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/core/types.h"
#include "cirque/domains/map_mesh.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/certificate.h"

#include "experiments/common/reference_factorization.h"
#include "experiments/run_experiment/config/planned_run.h"

namespace cirque {

/// Outcomes of runs beside those of StatusCode: ended at a limit; the strategy needs a form that the
/// energy has not; the other program failed; its map is not one, by the independent judge.
inline constexpr char kTimeLimit[] = "time_limit", kMemoryLimit[] = "memory_limit",
                      kUnsupported[] = "unsupported", kPeerFailed[] = "peer_failed",
                      kInvalidMap[] = "invalid_map";

/// What a run leaves behind. The certificate's outcome and message are always set.
struct RunResult {
  Index vertices = 0, triangles = 0;  ///< of the mesh; 0 when it could not be read
  Certificate certificate;
  /// Figures beside those of the certificate: the measures asked for, errors against a known map.
  std::map<std::string, double> figures = {};
  /// The mesh with its map, where the run keeps it and there is one; of a map to the sphere the
  /// mesh with its points there.
  PolygonSoup map = {};
  std::vector<double> energy_gradients = {};  ///< max |gradient| by iteration, of an EnergyTrial
  double seconds = 0;          ///< wall time, the reference left out; 0: until this is returned
  double cpu_seconds = 0;      ///< of this process, the reference left out
  double map_cpu_seconds = 0;  ///< the part of it after reading and making the surface
  double peak_memory_mib = 0;  ///< of this process until the run's end; 0: not known
  ReferenceFactorization reference = {};  ///< the fastest of three, where the run asks for it
};

/// Carries out one run; `mesh_path` is the mesh's file, empty for a generated mesh.
using RunFunction = std::function<RunResult(const PlannedRun& run, const std::string& mesh_path)>;

/// The real one: read or generate, repair and take apart, subdivide; then map to the domain and
/// measure, minimise an energy, or have another program map and judge what it made; then the reference.
RunResult ParameterizeRun(const PlannedRun& run, const std::string& mesh_path);

/// Maps the mesh, all of its components, to the run's domain with the run's method and measures the
/// map: certificate and, where the run keeps it, map of the result. `soup` is what was taken apart.
/// Stages that the certificate has timed already keep their times.
Status MapRun(const PlannedRun& run, const PolygonSoup& soup,
              const std::shared_ptr<const MeshParts>& parts, RunResult* result);

/// Minimises the run's energy on the surface, and sets outcome, message, EnergyFigures and times, which
/// are the solve's alone. Error: there are no coherent angles, or no minimiser to start from.
Status EnergyRun(const PlannedRun& run, const Surface& surface, RunResult* result);

/// Has the run's other program map the triangles, within the run's limits, and judges what it made
/// (cirque/verify): sets outcome, message, figures and times, which are those of the whole process.
Status PeerRun(const PlannedRun& run, const PolygonSoup& triangles, RunResult* result);

}  // namespace cirque

#include "bench/terrain.h"

#include <map>
#include <memory>

#include <glog/logging.h>

#include "cirque/angles/angle_fit.h"
#include "cirque/angles/registry.h"
#include "cirque/intrinsic/intrinsic_surface.h"

#include "bench/surfaces.h"

namespace cirque {
namespace {

std::unique_ptr<const EnergyInput> MakeInput(int triangles) {
  auto input = std::make_unique<EnergyInput>();
  const Surface& surface = BenchSurface("bumpy_terrain", triangles);
  const Triangulation& t = input->triangulation = surface.triangulation;
  input->targets = FreeBoundaryTargets(t);
  input->lengths = MeasureEdgeLengths(surface);
  input->reference = MeasureCornerAngles(t, input->lengths);
  for (const Eigen::Vector3d& p : surface.position) input->points.push_back(p.normalized());
  input->weights.assign(input->points.size(), 1);
  AngleFitResult fit;
  const Status status =
      FitAngles({AngleConstraints(t, input->targets), input->reference.value, input->epsilon},
                *AngleObjectives().Find("quadratic"), **MakeAngleSolver("newton"), {}, &fit);
  CHECK(status.ok()) << status.message();
  input->coherent = std::move(fit.angles);
  return input;
}

}  // namespace

const EnergyInput& Terrain(int triangles) {
  static std::map<int, std::unique_ptr<const EnergyInput>> cache;
  auto& input = cache[triangles];
  if (!input) input = MakeInput(triangles);
  return *input;
}

}  // namespace cirque

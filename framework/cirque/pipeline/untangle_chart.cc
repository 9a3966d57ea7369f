#include "cirque/pipeline/untangle_chart.h"

#include <algorithm>
#include <cmath>

#include "cirque/layout/untangle.h"

namespace cirque {
namespace {

/// Few faces are flipped, if any, and moving a vertex a little rights most of them.
int MoveVertices(const FlattenJob& job, InputChart* chart) {
  if (chart->flipped.empty()) return 0;
  std::vector<bool> movable = job.surface.boundary;
  for (Index v = 0; v < job.surface.triangulation.num_vertices; ++v) {
    movable[v] = !movable[v] && job.targets.IsFixed(v) && job.targets.lower[v] == 2 * kPi;
  }
  return UntangleFlippedTriangles(job.surface, movable, chart);
}

void AddWrapped(const Triangulation& t, const std::vector<double>& flat_angle_sums,
                InputChart* chart) {
  if (!chart->flipped.empty()) return;
  std::vector<double> excess = VertexAngleSums(t, chart->angles);
  for (std::size_t v = 0; v < excess.size(); ++v) excess[v] -= flat_angle_sums[v];
  for (Index f = 0; f < t.num_faces(); ++f) {
    const Index* corner = &t.vertex[3 * f];
    const bool wrapped =
        std::any_of(corner, corner + 3, [&](Index v) { return std::abs(excess[v]) > kPi; });
    if (wrapped) chart->flipped.push_back(f);
  }
}

}  // namespace

void UntangleChart(const FlattenJob& job, const std::vector<double>& flat_angle_sums,
                   TriangulationSummary* summary, InputChart* chart) {
  summary->flipped_in_chart = static_cast<int>(chart->flipped.size());
  summary->moved_vertices = MoveVertices(job, chart);
  AddWrapped(job.surface.triangulation, flat_angle_sums, chart);
}

}  // namespace cirque

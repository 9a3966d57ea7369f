// The files that stand beside a mesh: cones, angle sums, cuts, costs of edges, rotations, pins, curves.
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <glog/logging.h>

#include "cirque/cuts/edge_files.h"
#include "cirque/cuts/rotation_file.h"
#include "cirque/domains/curves.h"
#include "cirque/domains/pins.h"
#include "cirque/io/cone_file.h"
#include "cirque/io/io.h"
#include "cirque/mesh/preflight.h"

#include "tests/fuzz/fuzz_target.h"

namespace cirque::testing {
namespace {

constexpr char kPath[] = "side.txt";

/// What the files speak of: four triangles about vertex 1, and vertex 6, which belongs to none.
struct Mesh {
  Surface surface;
  FileVertices vertices;
};

Mesh MakeMesh() {
  const StatusOr<PolygonSoup> soup = ParseMesh("a.obj",
                                               "v 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nv 9 "
                                               "9 9\nf 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 2\n");
  CHECK(soup.ok());
  PreflightReport report;
  StatusOr<Surface> surface = Preflight(*soup, &report);
  CHECK(surface.ok());
  const auto count = static_cast<Index>(soup->position.size());
  Mesh mesh = {*std::move(surface), {count, {}}};
  mesh.vertices.of_vertex = mesh.surface.soup_vertex;
  return mesh;
}

const Mesh& TheMesh() {
  static const Mesh mesh = MakeMesh();
  return mesh;
}

void JudgeTargets(const StatusOr<ConeTargets>& targets) {
  if (!targets.ok()) return CheckRefusal(targets.status(), std::string(kPath) + ":");
  const Triangulation& t = TheMesh().surface.triangulation;
  const std::vector<Index> corners = CornersPerVertex(t);
  for (Index v = 0; v < t.num_vertices; ++v) {
    const double lower = targets->lower[v], upper = targets->upper[v];
    CHECK(0 <= lower && lower <= upper && upper > 0) << lower << " " << upper;
    CHECK_LE(upper, corners[v] * kPi * (1 + 1e-15));
  }
}

void RunCones(std::string_view bytes) {
  JudgeTargets(ParseConeFile(kPath, bytes, TheMesh().surface.triangulation, TheMesh().vertices));
}

void RunAngleSums(std::string_view bytes) {
  JudgeTargets(
      ParseAngleSumFile(kPath, bytes, TheMesh().surface.triangulation, TheMesh().vertices));
}

void RunCuts(std::string_view bytes) {
  const Triangulation& t = TheMesh().surface.triangulation;
  const FileNumbers numbers = NumbersInFile(TheMesh().surface);
  const StatusOr<Cut> cut = ParseCut(kPath, bytes, t, numbers);
  if (!cut.ok()) return CheckRefusal(cut.status(), std::string(kPath) + ":");
  for (Index e = 0; e < t.num_edges(); ++e) CHECK(!cut->edge[e] || !t.IsBoundaryEdge(e));
  const StatusOr<Cut> again = ParseCut(kPath, FormatCut(t, numbers, *cut), t, numbers);
  CHECK(again.ok() && again->edge == cut->edge);
}

void RunEdgeCosts(std::string_view bytes) {
  const Surface& surface = TheMesh().surface;
  const auto costs = ParseEdgeCosts(kPath, bytes, surface.triangulation, surface.soup_vertex);
  if (!costs.ok()) return CheckRefusal(costs.status(), std::string(kPath) + ":");
  CHECK_EQ(costs->size(), surface.triangulation.num_edges());
  CHECK(costs->allFinite() && costs->minCoeff() >= 0);
}

void RunRotations(std::string_view bytes) {
  const Triangulation& t = TheMesh().surface.triangulation;
  const auto loops = ParseRotations(kPath, bytes, t, NumbersInFile(TheMesh().surface));
  if (!loops.ok()) return CheckRefusal(loops.status(), std::string(kPath) + ":");
  for (const LoopRotation& loop : *loops) {
    CHECK(std::isfinite(loop.rotation));
    CHECK_EQ(CornersAlong(t, loop.path).size(), loop.path.entered.size());
  }
}

void RunPins(std::string_view bytes) {
  const Surface& surface = TheMesh().surface;
  const auto pins = ParsePins(kPath, bytes, surface);
  if (!pins.ok()) return CheckRefusal(pins.status(), std::string(kPath) + ":");
  std::set<Index> vertices;
  for (const Pin& pin : *pins) {
    CHECK(pin.at.allFinite());
    CHECK(0 <= pin.vertex && pin.vertex < surface.triangulation.num_vertices);
    CHECK(vertices.insert(pin.vertex).second) << pin.vertex;
  }
}

void RunCurve(std::string_view bytes) {
  const auto curve = ParseCurve(kPath, bytes);
  if (!curve.ok()) return CheckRefusal(curve.status(), std::string(kPath) + ":");
  CHECK(curve->length() > 0 && std::isfinite(curve->length()));
  CHECK_GE(curve->Area(), 0);
  for (std::size_t k = 0; k < curve->points().size(); ++k) {
    CHECK(curve->At(curve->arcs()[k]).allFinite());
    CHECK(std::abs(curve->TurningAt(k)) <= kPi);
  }
}

}  // namespace

std::vector<FuzzTarget> SideFileTargets() {
  const std::vector<std::string> words = {"#",   "\n",  "\r\n", " ",     "1.5",    "-0",
                                          "nan", "inf", "1e-9", "1e400", "1.#INF", "+2"};
  const std::vector<std::string> cone_files = {"framework/cirque/io/cone_file"};
  const std::vector<std::string> edge_files = {"framework/cirque/cuts/edge_files"};
  return {{"cones", RunCones, words, {"1 2\n", "# a cone\n1 1.5 2.5\n2 0 1\n3 .5\n"}, cone_files},
          {"angle_sums", RunAngleSums, words, {"6.28\n1.57\n1.57\n1.57\n1.57\n0\n"}, cone_files},
          {"cuts", RunCuts, words, {"1 2 1\n1 4 2\n", "3 1 1 # there and back\n"}, edge_files},
          {"edge_costs", RunEdgeCosts, words, {"1 2 0.5\n2 3 1e9\n"}, edge_files},
          {"rotations",
           RunRotations,
           words,
           {"1.5 1 2 3 4\n", "# back\n-1e-1 4 3 2 1\n"},
           {"framework/cirque/cuts/rotation_file"}},
          {"pins",
           RunPins,
           words,
           {"1 0 0\n2 1.5 -1\n# a third\n5 2e1 .5\n"},
           {"framework/cirque/domains/pins"}},
          {"curve",
           RunCurve,
           words,
           {"0 0\n1 0\n1 1\n0 1\n", "0 0\n-1 2\n3 0\n-1 -2\n0 0\n"},
           {"framework/cirque/domains/curves", "framework/cirque/math/closed_curve"}}};
}

}  // namespace cirque::testing

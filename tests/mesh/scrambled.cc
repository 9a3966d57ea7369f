#include "tests/mesh/scrambled.h"

#include <cmath>
#include <random>
#include <vector>

#include "cirque/generators/planar_delaunay.h"
#include "cirque/intrinsic/flip_complex.h"
#include "cirque/mesh/assembly.h"

namespace cirque::testing {

IntrinsicMesh Scramble(const IntrinsicMesh& mesh, int flips, unsigned seed) {
  FlipComplex complex(mesh.triangulation, mesh.lengths);
  std::mt19937 random(seed);
  for (int done = 0; done < flips;) {
    const auto h = static_cast<Index>(random() % complex.num_halfedges());
    const Index g = complex.twin(h);
    if (g == kNone || Triangulation::Face(g) == Triangulation::Face(h)) continue;
    const auto length = complex.OtherDiagonal(h);
    // Slivers are left alone: their lengths no longer say where they lie.
    if (!length || complex.RatioAfterFlip(h, *length) > 1e4) continue;
    complex.Flip(h, *length, kNone);
    ++done;
  }
  IntrinsicMesh scrambled;
  scrambled.triangulation = complex.MakeTriangulation(mesh.triangulation.num_vertices);
  scrambled.lengths = complex.MakeLengths(scrambled.triangulation);
  return scrambled;
}

IntrinsicMesh LatticeTorus(const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
  // Faces (0, u, u + v) and (0, u + v, v): sides v, u + v, u opposite their corners in turn.
  IntrinsicMesh mesh;
  mesh.triangulation = NumberEdges(1, std::vector<Index>(6, 0), {4, 5, 3, 2, 0, 1});
  const Triangulation& t = mesh.triangulation;
  mesh.lengths.value.resize(3);
  mesh.lengths.value[t.edge[0]] = v.norm();
  mesh.lengths.value[t.edge[1]] = (u + v).norm();
  mesh.lengths.value[t.edge[2]] = u.norm();
  return mesh;
}

IntrinsicMesh PeriodicPatch(int n, unsigned seed) {
  std::mt19937 random(seed);
  const auto jitter = [&] { return 0.8 * (random() / 4294967296.0) / n; };
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < n * n; ++i) {
    points.emplace_back(-1 + 2. * (i / n) / n + jitter(), -1 + 2. * (i % n) / n + jitter());
  }
  std::vector<Index> corners;
  for (const Triangle& triangle : PeriodicDelaunay(points, {2, 2})) {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
  const Gluing gluing = GlueEdges(corners, n * n, std::vector<Index>(corners.size(), kNone));
  IntrinsicMesh mesh;
  mesh.triangulation = NumberEdges(n * n, corners, gluing.mate);
  const Triangulation& t = mesh.triangulation;
  mesh.lengths.value.resize(t.num_edges());
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    const Eigen::Vector2d d = points[t.Tip(h)] - points[t.Tail(h)];
    mesh.lengths.value[e] = std::hypot(std::remainder(d.x(), 2), std::remainder(d.y(), 2));
  }
  return mesh;
}

}  // namespace cirque::testing

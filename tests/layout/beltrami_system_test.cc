#include "cirque/layout/beltrami_system.h"

#include <complex>
#include <numeric>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/opened_map.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

/// The terrain seen from above, as a map.
OpenedMap FromAbove(const Surface& terrain) {
  const Triangulation& t = terrain.triangulation;
  CornerUv uv;
  for (const Index v : t.vertex) uv.value.push_back(terrain.position[v].head<2>());
  const EdgeLengths lengths = MeasureEdgeLengths(terrain);
  const IntrinsicSurface surface = MeasureSurface(t, lengths);
  return OpenedMap({surface, {std::vector<bool>(t.num_edges(), false)}, {}}, uv, 0);
}

/// Every third vertex is held.
MapPart SomeOf(OpenedMap* map) {
  std::vector<bool> moves(map->open().num_vertices);
  for (std::size_t v = 0; v < moves.size(); ++v) moves[v] = v % 3 != 0;
  std::vector<Index> faces(map->open().num_faces());
  std::iota(faces.begin(), faces.end(), 0);
  return map->PartOf(moves, faces, {});
}

Eigen::VectorXcd Of(const MapPart& part, const Eigen::VectorXcd& z) {
  Eigen::VectorXcd own(static_cast<Eigen::Index>(part.vertex.size()));
  for (Eigen::Index i = 0; i < own.size(); ++i) own[i] = z[part.vertex[i]];
  return own;
}

TEST(EveryMapObjective, GradientIsThatOfTheValue) {
  OpenedMap map = FromAbove(GeneratedSurface("bumpy_terrain", 200));
  for (const MapPart& part : {map.Whole(), SomeOf(&map)}) {
    const Eigen::VectorXcd z = Of(part, map.z());
    Eigen::VectorXcd direction = Eigen::VectorXcd::Random(z.size());
    direction.tail(z.size() - part.unknowns).setZero();
    for (const std::string& name : MapObjectives().Names()) {
      SCOPED_TRACE(name);
      BeltramiSystem system(part, *MapObjectives().Find(name));
      system.Linearize(z, 0);
      const double step = 1e-7;
      const double slope =
          (system.Value(z + step * direction) - system.Value(z - step * direction)) / (2 * step);
      ASSERT_GT(std::abs(slope), 1e-3);
      const Complex along = system.gradient().dot(direction.head(part.unknowns));
      EXPECT_NEAR(along.real(), slope, 1e-6 * std::abs(slope));
    }
  }
}

TEST(EveryMapObjective, MatrixIsThatOfTheDerivativesOfMu) {
  OpenedMap map = FromAbove(GeneratedSurface("bumpy_terrain", 60));
  for (MapPart part : {map.Whole(), SomeOf(&map)}) {
    // Two edges as if they were the sides of a seam, one vertex of the four held or not.
    part.seams = {{{0, 1, 2, static_cast<Index>(part.vertex.size()) - 1}, {1, -1, -1, 1}, 0, 1}};
    const Eigen::VectorXcd z = Of(part, map.z());
    const auto n = static_cast<Eigen::Index>(part.vertex.size());
    for (const std::string& name : MapObjectives().Names()) {
      SCOPED_TRACE(name);
      const MapObjective objective = *MapObjectives().Find(name);
      BeltramiSystem system(part, objective);
      system.Linearize(z, 0);
      Eigen::MatrixXcd wanted = Eigen::MatrixXcd::Zero(n, n);
      for (const BeltramiFace& face : part.faces) {
        Complex above = 0, below = 0;
        for (int k = 0; k < 3; ++k) {
          above += z[face.vertex[k]] * face.hat[k];
          below += z[face.vertex[k]] * std::conj(face.hat[k]);
        }
        Eigen::RowVectorXcd derivative = Eigen::RowVectorXcd::Zero(n);
        for (int k = 0; k < 3; ++k) {
          derivative[face.vertex[k]] =
              (face.hat[k] - above / below * std::conj(face.hat[k])) / below;
        }
        const double weight = face.weight * objective.weight(std::norm(above / below));
        wanted += weight * derivative.adjoint() * derivative;
      }
      Eigen::RowVectorXcd seam = Eigen::RowVectorXcd::Zero(n);
      for (int k = 0; k < 4; ++k) seam[part.seams[0].vertex[k]] = part.seams[0].factor[k];
      const Eigen::MatrixXcd faces = wanted.topLeftCorner(part.unknowns, part.unknowns);
      const auto penalty =
          system.penalty()[0] * seam.head(part.unknowns).adjoint() * seam.head(part.unknowns);
      const Eigen::MatrixXcd lower = system.lower();
      const Eigen::MatrixXcd all = (faces + penalty).triangularView<Eigen::Lower>();
      EXPECT_LT((lower - all).norm(), 1e-12 * all.norm());
      // Away from the seam, whose stiffness outweighs them, the faces' entries are as they should be.
      const Eigen::Index rest = part.unknowns - 3;
      const Eigen::MatrixXcd away =
          faces.bottomRightCorner(rest, rest).triangularView<Eigen::Lower>();
      EXPECT_GT(system.penalty()[0], 1e6 * faces.cwiseAbs().minCoeff());
      if (part.unknowns < n) {
        EXPECT_LT((lower.bottomRightCorner(rest, rest) - away).norm(), 1e-12 * away.norm());
      }
    }
  }
}

TEST(BeltramiSystem, IsInfiniteWhereAFaceIsFlipped) {
  OpenedMap map = FromAbove(FlatStrip(2, 2));
  const MapPart part = map.Whole();
  const BeltramiSystem system(part, *MapObjectives().Find("mips"));
  EXPECT_LT(system.Value(Of(part, map.z())), 1e-28);
  Eigen::VectorXcd z = Of(part, map.z());
  z[4] += Complex(1.5, 0.1);  // over the edge of the square
  EXPECT_EQ(system.Value(z), std::numeric_limits<double>::infinity());
}

TEST(BeltramiSystem, TheShiftIsAShareOfEveryEntry) {
  OpenedMap map = FromAbove(GeneratedSurface("bumpy_terrain", 60));
  const MapPart part = map.Whole();
  BeltramiSystem system(part, *MapObjectives().Find("mips"));
  const Eigen::VectorXcd z = Of(part, map.z());
  system.Linearize(z, 0);
  const Eigen::VectorXcd plain = Eigen::MatrixXcd(system.lower()).diagonal();
  system.Linearize(z, 0.25);
  const Eigen::VectorXcd shifted = Eigen::MatrixXcd(system.lower()).diagonal();
  EXPECT_LT((shifted - 1.25 * plain).norm(), 1e-14 * plain.norm());
}

}  // namespace
}  // namespace cirque

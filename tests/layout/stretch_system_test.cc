#include "cirque/layout/stretch_system.h"

#include <cmath>
#include <complex>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/opened_map.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

/// The terrain seen from above, as a map: shrunk where it is steep.
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

/// The singular values of a face's real Jacobian, by Eigen.
double EnergyOfJacobian(const StretchEnergy& energy, const Eigen::Matrix2d& jacobian) {
  const Eigen::Vector2d s = jacobian.jacobiSvd().singularValues();
  return energy.terms(std::pow(s.sum() / 2, 2), std::pow((s[0] - s[1]) / 2, 2), energy.weight)
      .value;
}

/// The 4 x 4 Hessian of that by differences, without its negative eigenvalues.
Eigen::Matrix4d ProjectedHessian(const StretchEnergy& energy, const Eigen::Matrix2d& jacobian) {
  const double step = 1e-3;
  Eigen::Matrix4d hessian;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const auto at = [&](double along_i, double along_j) {
        Eigen::Matrix2d moved = jacobian;
        moved.data()[i] += along_i * step;
        moved.data()[j] += along_j * step;
        return EnergyOfJacobian(energy, moved);
      };
      hessian(i, j) = (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * step * step);
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(hessian);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() *
         solver.eigenvectors().transpose();
}

/// The Jacobian of a face as a linear function of its vertices' x0 y0 x1 y1 ..., column-major.
Eigen::Matrix<double, 4, 6> JacobianOf(const BeltramiFace& face) {
  Eigen::Matrix<double, 4, 6> jacobian = Eigen::Matrix<double, 4, 6>::Zero();
  for (int k = 0; k < 3; ++k) {
    // The hat's gradient is twice its derivative by z bar.
    const Complex gradient = 2 * face.scale * face.hat[k];
    for (int row = 0; row < 2; ++row) {
      jacobian(row, 2 * k + row) = gradient.real();
      jacobian(2 + row, 2 * k + row) = gradient.imag();
    }
  }
  return jacobian;
}

Eigen::MatrixXd Symmetric(const SparseMatrix& lower) {
  return Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
}

std::vector<StretchEnergy> AllEnergies() {
  std::vector<StretchEnergy> energies;
  for (const std::string& name : StretchEnergies().Names()) {
    energies.push_back(*StretchEnergies().Find(name));
  }
  return energies;
}

TEST(EveryStretchEnergy, GradientIsThatOfTheValue) {
  OpenedMap map = FromAbove(GeneratedSurface("bumpy_terrain", 200));
  MapPart drawn = SomeOf(&map);
  drawn.pulls = {{0, Complex(3, 1), 2.0}, {5, Complex(-1, 0), 0.5}};
  MapPart fenced = SomeOf(&map);
  fenced.fence = Fence{{{0, 1, 5}, {9, 4, 5}, {13, 20, 5}}, 1e-3};
  ASSERT_GT(fenced.fence->Contacts(Of(fenced, map.z())).size(), 2u);
  for (const MapPart& part : {map.Whole(), SomeOf(&map), drawn, fenced}) {
    const Eigen::VectorXcd z = Of(part, map.z());
    Eigen::VectorXcd direction = Eigen::VectorXcd::Random(z.size());
    direction.tail(z.size() - part.unknowns).setZero();
    for (const StretchEnergy& energy : AllEnergies()) {
      StretchSystem system(part, energy, 1.2);
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

TEST(EveryStretchEnergy, MatrixIsTheProjectedHessianOfTheFaces) {
  OpenedMap map = FromAbove(GeneratedSurface("bumpy_terrain", 60));
  const double unit = 1.1;
  for (const MapPart& part : {map.Whole(), SomeOf(&map)}) {
    const Eigen::VectorXcd z = Of(part, map.z());
    const auto n = static_cast<Eigen::Index>(part.vertex.size());
    for (const StretchEnergy& energy : AllEnergies()) {
      StretchSystem system(part, energy, unit);
      system.Linearize(z, 0);
      Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(2 * n, 2 * n);
      for (const BeltramiFace& face : part.faces) {
        const Eigen::Matrix<double, 4, 6> of = unit * JacobianOf(face);
        Eigen::Matrix<double, 6, 1> x;
        for (int k = 0; k < 3; ++k)
          x.segment<2>(2 * k) << z[face.vertex[k]].real(), z[face.vertex[k]].imag();
        const Eigen::Vector4d entries = of * x;
        const Eigen::Matrix2d jacobian = Eigen::Map<const Eigen::Matrix2d>(entries.data());
        const Eigen::Matrix<double, 6, 6> hessian =
            face.weight * of.transpose() * ProjectedHessian(energy, jacobian) * of;
        for (int k = 0; k < 3; ++k) {
          for (int l = 0; l < 3; ++l) {
            wanted.block<2, 2>(2 * face.vertex[k], 2 * face.vertex[l]) +=
                hessian.block<2, 2>(2 * k, 2 * l);
          }
        }
      }
      const Eigen::Index m = 2 * part.unknowns;
      ASSERT_EQ(system.lower().rows(), m);
      const Eigen::MatrixXd found = Symmetric(system.lower()), all = wanted.topLeftCorner(m, m);
      EXPECT_LT((found - all).norm(), 2e-3 * all.norm());
    }
  }
}

/// All of a terrain's map, of one energy.
struct WholeTerrain {
  OpenedMap map = FromAbove(GeneratedSurface("bumpy_terrain", 60));
  MapPart part = map.Whole();
  const StretchEnergy energy = *StretchEnergies().Find("symmetric_dirichlet");
  const Eigen::VectorXcd z = Of(part, map.z());

  /// Of the part as it stands.
  Eigen::MatrixXd Matrix() const {
    StretchSystem system(part, energy, 1);
    system.Linearize(z, 0);
    return Symmetric(system.lower());
  }
};

TEST(StretchSystem, SeamsAddTheirPenaltyAlsoWhereBothSidesEndInOneVertex) {
  WholeTerrain terrain;
  auto& [map, part, energy, z] = terrain;
  const Complex turn = std::polar(1.0, 0.7);
  const Eigen::MatrixXd plain = terrain.Matrix();
  part.seams = {{{0, 1, 2, 1}, {1, -1, -turn, turn}, 0, 1}};
  StretchSystem system(part, energy, 1);
  system.Linearize(z, 0);
  Eigen::MatrixXd row = Eigen::MatrixXd::Zero(2, 2 * part.unknowns);
  for (int k = 0; k < 4; ++k) {
    const Complex c = part.seams[0].factor[k];
    Eigen::Matrix2d multiply;
    multiply << c.real(), -c.imag(), c.imag(), c.real();
    row.middleCols<2>(2 * part.seams[0].vertex[k]) += multiply;
  }
  const Eigen::MatrixXd penalty = system.penalty()[0] * row.transpose() * row;
  EXPECT_GT(system.penalty()[0], 1e6 * plain.cwiseAbs().minCoeff());
  const Eigen::MatrixXd wanted = plain + penalty;
  EXPECT_LT((Symmetric(system.lower()) - wanted).norm(), 1e-12 * wanted.norm());
}

TEST(StretchSystem, FollowsTheContactsOfItsFence) {
  WholeTerrain terrain;
  auto& [map, part, energy, z] = terrain;
  const Eigen::MatrixXd without = terrain.Matrix();
  part.fence = Fence{{{0, 1, 100}, {part.unknowns - 1, part.unknowns - 2, 100}}, 0.5};
  StretchSystem system(part, energy, 1);
  system.Linearize(z, 0);
  // Gauss and Newton: of residuals r = reach / distance - 1, twice the weight of all r' r'^T.
  Eigen::MatrixXd wanted = without;
  for (const Contact& contact : part.fence->Contacts(z)) {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(2 * part.unknowns);
    const auto add = [&](Index v, double share) {
      row[2 * v] += share * contact.away.real(), row[2 * v + 1] += share * contact.away.imag();
    };
    add(contact.vertex, 1), add(contact.tail, contact.along - 1), add(contact.tip, -contact.along);
    row *= contact.reach / (contact.distance * contact.distance);
    wanted += 2 * 0.5 * row * row.transpose();
  }
  EXPECT_GT((wanted - without).norm(), 1e-3 * without.norm());
  EXPECT_LT((Symmetric(system.lower()) - wanted).norm(), 1e-12 * wanted.norm());
}

TEST(StretchSystem, RestrictsItselfToRails) {
  WholeTerrain terrain;
  auto& [map, part, energy, z] = terrain;
  const Eigen::MatrixXd free = terrain.Matrix();
  part.rails = {{3, std::polar(1.0, 0.4)}, {7, Complex(0)}};
  StretchSystem system(part, energy, 1);
  system.Linearize(z, 0);
  // The columns are the moves that there are: along the side, and round the origin.
  Eigen::MatrixXcd moves = Eigen::MatrixXcd::Zero(part.unknowns, 2 * part.unknowns - 2);
  for (Index v = 0; v < part.unknowns; ++v) {
    moves(v, system.FirstUnknown(v)) = 1;
    if (v != 3 && v != 7) moves(v, system.FirstUnknown(v) + 1) = Complex(0, 1);
  }
  moves(3, system.FirstUnknown(3)) = std::polar(1.0, 0.4);
  moves(7, system.FirstUnknown(7)) = Complex(0, 1) * z[7];
  Eigen::MatrixXd real(2 * part.unknowns, moves.cols());
  for (Index v = 0; v < part.unknowns; ++v) {
    real.row(2 * v) = moves.row(v).real();
    real.row(2 * v + 1) = moves.row(v).imag();
  }
  const Eigen::MatrixXd wanted = real.transpose() * free * real;
  EXPECT_LT((Symmetric(system.lower()) - wanted).norm(), 1e-12 * wanted.norm());
  // And it solves by what it has: the solution is such a move, and its residual in them is nothing.
  ASSERT_TRUE(system.Factorize(z, 1e-6));
  const Eigen::VectorXcd right = Eigen::VectorXcd::Random(part.unknowns);
  const Eigen::VectorXcd x = system.Solve(right);
  EXPECT_NEAR(std::imag(x[3] / std::polar(1.0, 0.4)), 0, 1e-12 * std::abs(x[3]));
  EXPECT_NEAR(std::real(x[7] / z[7]), 0, 1e-12 * std::abs(x[7]));
  Eigen::VectorXd unknown(moves.cols());
  for (Index v = 0; v < part.unknowns; ++v) {
    const Index at = system.FirstUnknown(v);
    const Complex in_frame = x[v] / moves(v, at);
    unknown[at] = in_frame.real();
    if (v != 3 && v != 7) unknown[at + 1] = in_frame.imag();
  }
  const Eigen::VectorXd wanted_right = (moves.adjoint() * right).real();
  const Eigen::VectorXd left = Symmetric(system.lower()) * unknown;
  EXPECT_LT((left - wanted_right).norm(), 1e-6 * wanted_right.norm());
}

TEST(StretchSystem, IsInfiniteWhereAFaceIsFlippedAndStepsEndBefore) {
  OpenedMap map = FromAbove(FlatStrip(2, 2));
  const MapPart part = map.Whole();
  const StretchSystem system(part, *StretchEnergies().Find("arap"), 2);
  // The strip has area 4: in the unit of its own lengths, areas of total 1, a factor of 2.
  const Eigen::VectorXcd z = Of(part, map.z());
  EXPECT_NEAR(system.Value(z), 2 * 9 + 0.01 * (16 + 1.0 / 16 - 2), 1e-12);
  Eigen::VectorXcd far = z;
  far[4] += Complex(1.5, 0.1);  // over the edge of the square
  EXPECT_EQ(system.Value(far), std::numeric_limits<double>::infinity());
  Eigen::VectorXcd direction = Eigen::VectorXcd::Zero(z.size());
  direction[4] = Complex(4, 0);  // the inner vertex reaches the boundary after a quarter
  const double longest = system.LongestStep(z, direction);
  EXPECT_NEAR(longest, 0.9 * 0.25, 1e-12);
  EXPECT_TRUE(std::isfinite(system.Value(z + longest * direction)));
  direction[4] = Complex(1e-9, 0);
  EXPECT_EQ(system.LongestStep(z, direction), 256);
}

TEST(BestUnit, IsTheScaleThatTheImageMisses) {
  // A square of side 3 for a surface of area 1.
  OpenedMap map = FromAbove(FlatStrip(3, 3));
  for (const StretchEnergy& energy : AllEnergies()) {
    EXPECT_NEAR(BestUnit(map.faces(), energy, map.z()), 1.0 / 3, 1e-10);
    EXPECT_NEAR(BestUnit(map.faces(), energy, 1e4 * map.z()), 1e-4 / 3, 1e-14);
  }
  OpenedMap terrain = FromAbove(GeneratedSurface("bumpy_terrain", 200));
  for (const StretchEnergy& energy : AllEnergies()) {
    const double unit = BestUnit(terrain.faces(), energy, terrain.z());
    const auto at = [&](double factor) {
      return StretchOf(terrain.faces(), energy, factor * unit, terrain.z());
    };
    EXPECT_LT(at(1), at(1.001));
    EXPECT_LT(at(1), at(0.999));
  }
}

}  // namespace
}  // namespace cirque

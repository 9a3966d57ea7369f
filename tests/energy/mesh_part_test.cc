// Parts of surfaces for ranks: rows that owners assemble are those of the whole, to the last bit.
#include "cirque/energy/mesh_part.h"

#include <map>

#include <gtest/gtest.h>

#include "cirque/energy/circle_pattern_energy.h"
#include "cirque/energy/circle_pattern_source.h"
#include "cirque/energy/dual_angle_energy.h"
#include "cirque/energy/energy_parts.h"

#include "tests/common/renumbering.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

constexpr int kRanks = 3;

/// A row of a symmetric matrix: column to value.
using Row = std::map<int, double>;

/// Row `row` of the matrix with that lower triangle; columns as `name` calls them.
Row RowOf(const SparseMatrix& lower, int row, const std::vector<int>& name) {
  Row found;
  for (int j = 0; j < lower.cols(); ++j) {
    for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry) {
      const auto i = static_cast<int>(entry.row());
      if (i == row) found[name[j]] = entry.value();
      if (j == row) found[name[i]] = entry.value();
    }
  }
  return found;
}

/// Own parameters of the part whose Hessian row there is not that of the whole.
int RowsThatDiffer(const Energy& whole, const EnergySource& source, const MeshPart& part,
                   int rank) {
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(whole.NumParameters(), -0.4, 0.5);
  Eigen::VectorXd of_part(static_cast<Eigen::Index>(part.parameter.size()));
  for (Eigen::Index p = 0; p < of_part.size(); ++p) of_part[p] = x[part.parameter[p]];
  const EnergyData data = source.DataOf(part);
  const auto energy = EnergyPartMakers().at(source.Work())(part.triangulation, data);
  EXPECT_EQ(energy->NumParameters(), of_part.size());
  SparseMatrix wanted, got;
  EXPECT_TRUE(whole.Hessian(x.data(), &wanted));
  EXPECT_TRUE(energy->Hessian(of_part.data(), &got));
  std::vector<int> same(whole.NumParameters());
  for (int p = 0; p < whole.NumParameters(); ++p) same[p] = p;
  int differ = 0;
  for (std::size_t p = 0; p < part.number.size(); ++p) {
    if (part.number[p] < part.first[rank] || part.number[p] >= part.first[rank + 1]) continue;
    const Row of_whole = RowOf(wanted, part.parameter[p], same);
    EXPECT_GT(of_whole.size(), 1u);
    if (of_whole != RowOf(got, static_cast<int>(p), part.parameter)) ++differ;
  }
  return differ;
}

class MeshPartTest : public ::testing::Test {
 protected:
  MeshPartTest()
      : surface_(GeneratedSurface("bumpy_terrain", 150)),
        angles_{Eigen::VectorXd::Constant(t().num_halfedges(), kPi / 3)},
        reference_(AnglesOf(surface_)),
        pattern_(t(), angles_),
        pattern_source_(t(), angles_),
        dual_(AngleConstraints(t(), FreeBoundaryTargets(t())), reference_.value, 0.05,
              *AngleObjectives().Find("quadratic")) {}

  const Triangulation& t() const { return surface_.triangulation; }

  const Surface surface_;
  const CoherentAngles angles_;
  const CornerAngles reference_;
  const CirclePatternEnergy pattern_;
  const CirclePatternSource pattern_source_;
  const DualAngleEnergy dual_;
};

TEST_F(MeshPartTest, EveryParameterHasOneOwner) {
  const MeshPartition parts(t(), dual_.source()->VertexParameters(), kRanks);
  std::vector<int> owners(dual_.NumParameters(), 0), by_number(dual_.NumParameters(), kNone);
  for (int r = 0; r < kRanks; ++r) {
    const MeshPart part = parts.Part(r);
    EXPECT_EQ(part.first.back(), dual_.NumParameters());
    EXPECT_NEAR(part.first[r + 1] - part.first[r], dual_.NumParameters() / kRanks,
                0.2 * dual_.NumParameters());
    for (std::size_t p = 0; p < part.number.size(); ++p) {
      const int number = part.number[p];
      if (number >= part.first[r] && number < part.first[r + 1]) ++owners[part.parameter[p]];
      // All ranks call a parameter by the same number.
      if (by_number[number] == kNone) by_number[number] = part.parameter[p];
      EXPECT_EQ(by_number[number], part.parameter[p]);
    }
  }
  for (const int count : owners) EXPECT_EQ(count, 1);
}

TEST_F(MeshPartTest, BordersAreShortWhateverTheNumbersOfTheFaces) {
  const Renumbering shuffled = Renumber(GeneratedSurface("bumpy_terrain", 2000).triangulation, 7);
  const Triangulation& many = shuffled.triangulation;
  const MeshPartition parts(many, {}, kRanks);
  for (int r = 0; r < kRanks; ++r) {
    EXPECT_LT(parts.Part(r).face.size(), many.num_faces() / kRanks + 150);
  }
}

TEST_F(MeshPartTest, OwnersAssembleTheRowsOfTheWhole) {
  const MeshPartition of_faces(t(), {}, kRanks),
      of_all(t(), dual_.source()->VertexParameters(), kRanks);
  for (int r = 0; r < kRanks; ++r) {
    EXPECT_EQ(RowsThatDiffer(pattern_, pattern_source_, of_faces.Part(r), r), 0);
    EXPECT_EQ(RowsThatDiffer(dual_, *dual_.source(), of_all.Part(r), r), 0);
  }
}

TEST_F(MeshPartTest, AWrongOwnerIsNoticed) {
  MeshPart part = MeshPartition(t(), dual_.source()->VertexParameters(), kRanks).Part(1);
  // The outermost faces and vertices, told to be the rank's own, lack what lies beyond.
  for (int& number : part.number) {
    const bool is_own = number >= part.first[1] && number < part.first[2];
    number = is_own ? part.first[2] : part.first[1];
  }
  EXPECT_GT(RowsThatDiffer(dual_, *dual_.source(), part, 1), 5);
}

}  // namespace
}  // namespace cirque

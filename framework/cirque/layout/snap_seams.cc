#include "cirque/layout/snap_seams.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <glog/logging.h>

namespace cirque {
namespace {

/// The rotation by multiple 2 pi / order; by right angles without rounding.
Eigen::Matrix2d Rotation(int multiple, int order) {
  Eigen::Matrix2d rotation;
  if ((4 * multiple) % order == 0) {
    constexpr std::array<int, 4> kCosine = {1, 0, -1, 0};
    const int quarter = ((4 * multiple / order) % 4 + 4) % 4;
    const int c = kCosine[quarter], s = kCosine[(quarter + 3) % 4];
    rotation << c, -s, s, c;
  } else {
    const double angle = 2 * kPi * multiple / order;
    rotation << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  }
  return rotation;
}

class Snapper {
 public:
  Snapper(const Triangulation& t, const Cut& cut, const CornerUv& uv)
      : t_(t), open_(CutOpen(t, cut)), position_(open_.num_vertices) {
    for (Index c = 0; c < open_.num_halfedges(); ++c) position_[open_.vertex[c]] = uv.value[c];
  }

  void Snap(const std::vector<Seam>& seams, const std::vector<Eigen::Matrix2d>& rotation) {
    // What rounding leaves of the first displacement, the next ones take away.
    constexpr int kRounds = 3;
    for (int round = 0; round < kRounds; ++round) AgreeAtNodes(seams, rotation);
    for (std::size_t i = 0; i < seams.size(); ++i) MoveRightSide(seams[i], rotation[i]);
  }

  /// Hands the positions back; returns the largest displacement.
  double WriteTo(CornerUv* uv) const {
    double moved = 0;
    for (Index c = 0; c < open_.num_halfedges(); ++c) {
      const Eigen::Vector2d& p = position_[open_.vertex[c]];
      moved = std::max(moved, (p - uv->value[c]).norm());
      uv->value[c] = p;
    }
    return moved;
  }

 private:
  Index Left(Index corner) const { return open_.vertex[corner]; }
  Index LeftTail(Index h) const { return Left(Triangulation::Next(h)); }
  Index LeftTip(Index h) const { return Left(Triangulation::Prev(h)); }
  Index RightTail(Index h) const { return LeftTip(t_.twin[h]); }
  Index RightTip(Index h) const { return LeftTail(t_.twin[h]); }

  /// Displaces the ends of seams least so that right - R left is the same at both ends of each.
  void AgreeAtNodes(const std::vector<Seam>& seams, const std::vector<Eigen::Matrix2d>& rotation) {
    std::vector<Index> number(open_.num_vertices, kNone), vertex;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd wanted(2 * seams.size());
    for (std::size_t i = 0; i < seams.size(); ++i) {
      const Index first = seams[i].halfedges.front(), last = seams[i].halfedges.back();
      const std::array<Index, 4> end = {RightTail(first), LeftTail(first), RightTip(last),
                                        LeftTip(last)};
      const Eigen::Matrix2d one = Eigen::Matrix2d::Identity();
      const std::array<Eigen::Matrix2d, 4> factor = {one, -rotation[i], -one, rotation[i]};
      Eigen::Vector2d gap(0, 0);
      for (int k = 0; k < 4; ++k) {
        gap += factor[k] * position_[end[k]];
        if (number[end[k]] == kNone) {
          number[end[k]] = static_cast<Index>(vertex.size());
          vertex.push_back(end[k]);
        }
        for (int entry = 0; entry < 4; ++entry) {
          const int row = entry / 2, column = entry % 2;
          entries.emplace_back(2 * i + row, 2 * number[end[k]] + column, factor[k](row, column));
        }
      }
      wanted.segment<2>(2 * i) = -gap;
    }
    Eigen::SparseMatrix<double> agreement(wanted.size(), 2 * vertex.size());
    agreement.setFromTriplets(entries.begin(), entries.end());
    Displace(agreement, wanted, vertex);
  }

  /// Conjugate gradients from zero find the least of all solutions.
  void Displace(const Eigen::SparseMatrix<double>& agreement, const Eigen::VectorXd& wanted,
                const std::vector<Index>& vertex) {
    Eigen::LeastSquaresConjugateGradient<Eigen::SparseMatrix<double>, Eigen::IdentityPreconditioner>
        solver(agreement);
    const Eigen::VectorXd displacement = solver.solve(wanted);
    if (!displacement.allFinite()) return;
    for (std::size_t i = 0; i < vertex.size(); ++i) {
      position_[vertex[i]] += displacement.segment<2>(2 * i);
    }
  }

  /// The vertices between the seam's ends; each lies on this seam alone.
  void MoveRightSide(const Seam& seam, const Eigen::Matrix2d& rotation) {
    const Index first = seam.halfedges.front();
    const Eigen::Vector2d translation =
        position_[RightTail(first)] - rotation * position_[LeftTail(first)];
    for (std::size_t i = 0; i + 1 < seam.halfedges.size(); ++i) {
      const Index h = seam.halfedges[i];
      position_[RightTip(h)] = rotation * position_[LeftTip(h)] + translation;
    }
  }

  const Triangulation& t_;
  Triangulation open_;
  std::vector<Eigen::Vector2d> position_;
};

}  // namespace

double SnapSeams(const Triangulation& t, const Cut& cut, const SeamReport& report,
                 const std::vector<int>& multiple, int order, CornerUv* uv) {
  CHECK_EQ(multiple.size(), report.seams.size());
  if (report.seams.empty()) return 0;
  std::vector<Eigen::Matrix2d> rotation;
  for (const int m : multiple) rotation.push_back(Rotation(m, order));
  Snapper snapper(t, cut, *uv);
  snapper.Snap(report.seams, rotation);
  return snapper.WriteTo(uv);
}

}  // namespace cirque

#pragma once

#include <atomic>
#include <vector>

#include <Eigen/Core>

#include "cirque/cones/cone.h"
#include "cirque/cones/cone_problem.h"
#include "cirque/cones/rotation_model.h"
#include "cirque/core/grouping.h"

namespace cirque {

/// Moves cones of fixed curvatures, multiples of a unit, to where the rotations along all loops of
/// a model are near multiples of that unit too, and the area distortion little more than it must
/// be:
///   F = sum_q dist(r_q, multiples)^2 + weight |u|^2,
/// r_q of the RotationModel, u of the ConeProblem. A move takes a cone to a vertex within three
/// rings, at five corners or more, beside no other cone; what it does to r is one column of the
/// model, to |u|^2, at first, a difference of the gradient d|u|^2 / dmu = 2 L^-1 M u. First the
/// area alone descends; then the move that lowers F most, and the rotations' part of it, is made,
/// one after the other, and where none does the best pair of moves, whose turns add up; with less
/// and less weight on the area until all rotations are within the goal.
///
/// Cones that are ranged, or on the boundary, stay.
class SeamlessSearch {
 public:
  /// Problem and model must outlive the search. Of `cones` fixed ones at candidates are moved.
  SeamlessSearch(const ConeProblem& problem, const RotationModel& model, std::vector<Cone> cones,
                 double unit);

  /// Moves cones one by one to less area distortion, whatever turns.
  void DescendArea(const std::atomic<bool>* cancelled);

  /// The search. `offset`: what is added to the model's rotations, as measured of a finished
  /// metric.
  void Run(const Eigen::VectorXd& offset, const std::atomic<bool>* cancelled);

  const std::vector<Cone>& cones() const { return cones_; }
  int moves() const { return moves_; }
  double Miss() const;            ///< the largest distance of a rotation to a multiple [rad]
  double AreaDistortion() const;  ///< sqrt(sum_v a_v u_v^2)

 private:
  struct Move {
    int cone;
    Index to;
    double area;           ///< first-order change of |u|^2
    Eigen::VectorXd turn;  ///< of every rotation
  };

  std::vector<Index> Rings(Index v) const;
  bool MayLieAt(int cone, Index v) const;
  std::vector<Move> Moves(int cone) const;
  std::vector<Move> AllMoves() const;
  Eigen::VectorXd Rest() const;  ///< of every rotation beyond its nearest multiple
  double RestAfter(const Move& move) const;
  bool BestSingle();
  bool GoTogether(const Move& a, const Move& b);
  bool BestPair();
  bool TryAreaMove(int cone);
  void Take(const Move& move);
  void UpdateSlope();

  const ConeProblem& problem_;
  const RotationModel& model_;
  const Buckets corners_at_;
  const double unit_;
  std::vector<Cone> cones_;
  std::vector<bool> taken_;
  Eigen::VectorXd rotations_, offset_;
  Eigen::VectorXd u_, slope_;  ///< V: log scale, and L^-1 M u
  double weight_ = 0;          ///< of the area
  int moves_ = 0;
};

}  // namespace cirque

#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "cirque/cones/cone.h"
#include "cirque/cones/cone_fit.h"
#include "cirque/cones/cone_problem.h"
#include "cirque/core/status.h"

namespace cirque {

/// Chooses vertices one by one for a given number of cones such that admissible curvatures can
/// still add up to 2 pi chi at the end: on a surface of high genus few cones must lie at vertices
/// with many corners.
class ConeChoice {
 public:
  /// Of `count` cones, or of as many more as it takes to carry the total curvature of a closed
  /// surface. Error (invalid input): all its vertices together cannot carry it.
  static StatusOr<ConeChoice> Make(const ConeProblem& problem, int count);

  int left() const { return left_; }

  /// The unchosen vertex of greatest score (V; the first of equals) that keeps the total within
  /// reach, now chosen; nothing when `left` is 0 or every score left is minus infinity.
  std::optional<Index> TakeBest(const Eigen::VectorXd& score);

 private:
  ConeChoice(const ConeProblem& problem, int count);
  double LeastOfOthers(int count, std::vector<bool>* among) const;
  bool CanCarryTotal(double least) const;

  const ConeProblem* problem_;
  int left_;
  double chosen_least_ = 0;  ///< sum of the least curvatures of the chosen
  std::vector<bool> chosen_;
  std::vector<Index> by_capacity_;  ///< candidates by least curvature, increasing
};

/// How far a field known up to a constant on closed surfaces (u, or ConeFit::Descent) is at each
/// vertex from its level at the cones so far, 0 with a boundary. Before there are cones on a closed
/// surface: from its end that lies away from where curvature of the sign of chi belongs. V.
Eigen::VectorXd DistanceFromCones(const ConeProblem& problem, const ConeFit& fit,
                                  const Eigen::VectorXd& field);

/// Makes the curvatures of a fit those of least squares, with further vertices of the choice, those
/// with most corners first, while admissible ones cannot add up. False when none is left to take.
bool FitAdmissible(const ConeProblem& problem, ConeChoice* choice, ConeFit* fit);

/// At most `count` cones, or as many as Gauss-Bonnet needs, with the admissible curvatures of least
/// distortion, each chosen where a little curvature lowers the distortion of those before it most, among the vertices that are
/// `allowed` (V). Where these are too few for Gauss-Bonnet, vertices with many corners are added.
/// Error (invalid input) as of ConeChoice::Make.
StatusOr<std::vector<Cone>> ChooseByDescent(const ConeProblem& problem,
                                            const std::vector<bool>& allowed, int count);

}  // namespace cirque

#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "cirque/linear/halo.h"
#include "cirque/linear/multigrid.h"

namespace cirque {

/// What MakeEliminatingCholesky does, on ranks: each eliminates by hand own unknowns with at most
/// three neighbours, all its own and none of them eliminated, and leaves the Schur complement's
/// rows of those that it keeps. Unknowns that it would eliminate but for neighbours on other ranks
/// change their sign there if their couplings are positive, as a triangle's of an angle fit to its
/// vertices are: multigrid wants a graph's Laplacian.
class LocalElimination {
 public:
  static constexpr int kMaxNeighbours = 3;

  /// Chooses by the pattern, and numbers what all ranks keep. Collective; rows of the halo's own
  /// unknowns, of a symmetric pattern.
  LocalElimination(const LocalRows& rows, const Halo& halo);

  /// Takes the values of rows with that pattern. False where a diagonal entry of an own unknown is
  /// not positive. Collective.
  bool SetValues(const LocalRows& rows, const Halo& halo);

  /// The complement's rows. @pre SetValues was called with these rows.
  MatrixRows Complement(const LocalRows& rows) const;

  /// Whether they keep the same of the own unknowns. Not collective.
  bool HasSameKept(const LocalElimination& other) const { return kept_ == other.kept_; }

  int num_kept() const { return static_cast<int>(kept_.size()); }

  /// The right side of the kept, for b of the own.
  Eigen::VectorXd Reduce(const Eigen::VectorXd& b) const;

  /// x of the own, from that of the kept and b.
  void Expand(const Eigen::VectorXd& of_kept, const Eigen::VectorXd& b, Eigen::VectorXd* x) const;

 private:
  struct Eliminated {
    int unknown, count = 0;
    std::array<int, kMaxNeighbours> kept = {};  ///< places among the kept
    double inverse = 0;                         ///< of the diagonal entry
    std::array<double, kMaxNeighbours> coupling = {};
  };

  /// Calls visit(i, x) for every entry (j, i), x of the complement, some of them several times.
  template <class Visit>
  void ForEachInRow(const LocalRows& rows, int j, const Visit& visit) const;

  /// Calls visit(row) for those of the complement: pairs of column and value.
  template <class Visit>
  void ForEachRow(const LocalRows& rows, const Visit& visit) const;

  void Choose(const LocalRows& rows);
  void NumberKept(const Halo& halo);

  std::vector<int> kept_;    ///< own unknowns, increasing
  std::vector<int> place_;   ///< per own unknown: among the kept, or ~(among the eliminated)
  std::vector<int> number_;  ///< per local unknown that is kept: in the complement
  std::vector<Eliminated> eliminated_;
  Eigen::VectorXd sign_;  ///< per local unknown: 1 or -1
  int size_ = 0;          ///< of the complement
};

}  // namespace cirque

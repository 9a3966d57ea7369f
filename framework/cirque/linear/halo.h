#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/linear/ranks.h"
#include "cirque/linear/sparse_matrix.h"

namespace cirque {

/// Which unknowns a rank has. They are numbered rank by rank: [first[r], first[r + 1]) are its own.
/// Beside those it keeps copies of others that its rows couple to, the ghosts. Local numbers are
/// those of the own unknowns from 0, then those of the ghosts.
struct RankUnknowns {
  std::vector<int> first;   ///< per rank, and the end
  std::vector<int> ghosts;  ///< numbers, increasing
};

/// Brings the ghosts' values from the ranks that own them.
class Halo {
 public:
  /// Collective.
  Halo(Ranks* ranks, const RankUnknowns& unknowns);

  int num_own() const { return num_own_; }
  int num_ghosts() const { return first_ghost_.back(); }
  int num_local() const { return num_own() + num_ghosts(); }
  Ranks& ranks() const { return ranks_; }

  /// Takes values of local unknowns, of which those of the ghosts become their owners'. Collective.
  void Fill(Eigen::VectorXd* local) const { FillArray(local->data()); }
  void Fill(std::vector<int>* local) const { FillArray(local->data()); }

 private:
  template <class T>
  void FillArray(T* local) const;

  Ranks& ranks_;
  int num_own_;
  std::vector<int> first_ghost_;        ///< per rank that owns them, and the end
  std::vector<std::vector<int>> sent_;  ///< per rank: the own unknowns that it has copies of
};

/// Rows of a symmetric matrix, those of a rank's own unknowns, by local numbers; each begins with
/// its diagonal entry.
struct LocalRows {
  std::vector<int> start;  ///< number of rows + 1
  std::vector<int> column;
  std::vector<double> value;

  int num_rows() const { return static_cast<int>(start.size()) - 1; }
  double& Diagonal(int row) { return value[start[row]]; }
  double Diagonal(int row) const { return value[start[row]]; }

  /// The rows' product with x of all local unknowns.
  Eigen::VectorXd Times(const Eigen::VectorXd& x) const;
};

/// Those of a matrix of other numbers, of which `slot` gives the local ones: the `num_own` first.
LocalRows OwnRows(const SparseMatrix& lower, const std::vector<int>& slot, int num_own);

}  // namespace cirque

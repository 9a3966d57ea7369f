#pragma once

#ifdef CIRQUE_CHOLMOD

#include <vector>

#include <cholmod.h>

namespace cirque {

/// The elimination tree of a supernodal factor of CHOLMOD, cut for work on several cores: into
/// branches that do not see each other, dealt into groups of about equal work, and the trunk of
/// large supernodes above them. The cut depends on the factor's pattern alone.
class SupernodalTree {
 public:
  /// Supernodes begin to end - 1: one branch, or several side by side.
  struct Branches {
    int begin, end;
  };
  using Group = std::vector<Branches>;

  /// @pre the factor is analysed, and outlives this.
  explicit SupernodalTree(const cholmod_factor& factor);

  int num_columns() const { return static_cast<int>(factor_.n); }
  int num_supernodes() const { return static_cast<int>(factor_.nsuper); }
  int FirstColumn(int s) const { return first_column_[s]; }
  int NumColumns(int s) const { return first_column_[s + 1] - first_column_[s]; }

  /// The rows of the factor that are not zero in the columns of s, increasing; its own come first.
  const int* Rows(int s) const { return rows_ + first_row_[s]; }
  int NumRows(int s) const { return first_row_[s + 1] - first_row_[s]; }
  int most_rows() const { return most_rows_; }

  /// That of a column.
  int SupernodeOf(int column) const { return supernode_[column]; }

  const std::vector<Group>& groups() const { return groups_; }

  /// Its supernodes, increasing.
  const std::vector<int>& trunk() const { return trunk_; }

  /// The columns of the trunk, increasing, and a column's number among them, kNone elsewhere.
  const std::vector<int>& trunk_columns() const { return trunk_columns_; }
  int TrunkNumber(int column) const { return trunk_number_[column]; }

  /// How many rows of s come before those that lie in the trunk while s does not.
  int NumNear(int s) const { return num_near_[s]; }

 private:
  double Work(int s) const { return static_cast<double>(NumRows(s)) * NumColumns(s); }
  std::vector<int> FindParents() const;
  void FindTrunk(const std::vector<int>& parent);
  void DealOutBranches(const std::vector<int>& parent);
  int CountNear(int s) const;

  const cholmod_factor& factor_;
  const int *first_column_, *first_row_, *rows_;
  double work_ = 0;  ///< of all
  int most_rows_ = 0;
  std::vector<int> supernode_;
  std::vector<bool> in_trunk_;
  std::vector<Group> groups_;
  std::vector<int> trunk_, trunk_columns_, trunk_number_, num_near_;
};

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD

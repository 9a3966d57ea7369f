#pragma once

#ifdef CIRQUE_CHOLMOD

#include <vector>

#include <cholmod.h>

namespace cirque {

/// The elimination tree of a supernodal factor of CHOLMOD, cut for work on several cores: into
/// subtrees that do not see each other, dealt into groups of about equal work, and the top of
/// large supernodes above them. The cut depends on the factor's pattern alone.
class SupernodalTree {
 public:
  /// Supernodes begin to end - 1: one subtree, or several side by side.
  struct Subtrees {
    int begin, end;
  };
  using Group = std::vector<Subtrees>;

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
  const std::vector<int>& top_supernodes() const { return top_; }

  /// The columns of the top, increasing, and a column's number among them, kNone elsewhere.
  const std::vector<int>& top_columns() const { return top_columns_; }
  int TopNumber(int column) const { return top_number_[column]; }

  /// How many rows of s come before those that lie in the top while s does not.
  int NumNear(int s) const { return num_near_[s]; }

 private:
  double Work(int s) const { return static_cast<double>(NumRows(s)) * NumColumns(s); }
  std::vector<int> FindParents() const;
  void FindTopSupernodes(const std::vector<int>& parent);
  void DealOutSubtrees(const std::vector<int>& parent);
  int CountNear(int s) const;

  const cholmod_factor& factor_;
  const int *first_column_, *first_row_, *rows_;
  double work_ = 0;  ///< of all
  int most_rows_ = 0;
  std::vector<int> supernode_;
  std::vector<bool> is_top_;
  std::vector<Group> groups_;
  std::vector<int> top_, top_columns_, top_number_, num_near_;
};

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD

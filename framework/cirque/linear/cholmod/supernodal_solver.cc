#ifdef CIRQUE_CHOLMOD

#include "cirque/linear/cholmod/supernodal_solver.h"

#include <algorithm>

#include "cirque/core/parallel.h"

namespace cirque {

SupernodalSolver::SupernodalSolver(const SupernodalTree& tree, const int* order)
    : tree_(tree),
      order_(order),
      x_(tree.num_columns()),
      far_(tree.groups().size()),
      work_(far_.size(), Eigen::VectorXd(tree.most_rows() + SupernodeNumbers::kPadding)) {}

void SupernodalSolver::Forward(const SupernodeNumbers& numbers, int s, double* far,
                               Eigen::VectorXd* work) {
  const int rows = tree_.NumRows(s), columns = tree_.NumColumns(s);
  double *x = x_.data(), *w = work->data();
  const double* own = x + tree_.FirstColumn(s);
  // Of a right side of few entries most supernodes have nothing to pass on.
  if (std::all_of(own, own + columns, [](double value) { return value == 0; })) return;
  std::copy_n(own, columns, w);
  std::fill_n(w + columns, rows - columns + SupernodeNumbers::kPadding, 0.0);
  numbers.Solve(s, w);
  std::copy_n(w, columns, x + tree_.FirstColumn(s));
  const int* row = tree_.Rows(s);
  const int near = tree_.NumNear(s);
  for (int k = columns; k < near; ++k) x[row[k]] += w[k];
  for (int k = near; k < rows; ++k) far[tree_.TopNumber(row[k])] += w[k];
}

void SupernodalSolver::Backward(const SupernodeNumbers& numbers, int s, Eigen::VectorXd* work) {
  const int rows = tree_.NumRows(s), columns = tree_.NumColumns(s);
  double *x = x_.data(), *w = work->data();
  std::copy_n(x + tree_.FirstColumn(s), columns, w);
  const int* row = tree_.Rows(s);
  for (int k = columns; k < rows; ++k) w[k] = x[row[k]];
  std::fill_n(w + rows, SupernodeNumbers::kPadding, 0.0);
  numbers.SolveTransposed(s, w);
  std::copy_n(w, columns, x + tree_.FirstColumn(s));
}

void SupernodalSolver::ForwardAll(const SupernodeNumbers& numbers) {
  const auto& top_columns = tree_.top_columns();
  ParallelTasks(static_cast<int>(far_.size()), [&](int g) {
    far_[g].setZero(top_columns.size());
    for (const auto& subtrees : tree_.groups()[g]) {
      for (int s = subtrees.begin; s < subtrees.end; ++s) {
        Forward(numbers, s, far_[g].data(), &work_[g]);
      }
    }
  });
  for (const Eigen::VectorXd& of_group : far_) {
    for (std::size_t k = 0; k < top_columns.size(); ++k) x_[top_columns[k]] += of_group[k];
  }
  for (const int s : tree_.top_supernodes()) Forward(numbers, s, nullptr, &work_.front());
}

void SupernodalSolver::BackwardAll(const SupernodeNumbers& numbers) {
  for (auto s = tree_.top_supernodes().rbegin(); s != tree_.top_supernodes().rend(); ++s) {
    Backward(numbers, *s, &work_.front());
  }
  ParallelTasks(static_cast<int>(work_.size()), [&](int g) {
    const auto& group = tree_.groups()[g];
    for (auto subtrees = group.rbegin(); subtrees != group.rend(); ++subtrees) {
      for (int s = subtrees->end; s-- > subtrees->begin;) Backward(numbers, s, &work_[g]);
    }
  });
}

void SupernodalSolver::Solve(const SupernodeNumbers& numbers, const Eigen::VectorXd& b,
                             Eigen::VectorXd* x) {
  const int n = tree_.num_columns();
  ParallelFor(n, [&](int k) { x_[k] = b[order_[k]]; });
  ForwardAll(numbers);
  BackwardAll(numbers);
  x->resize(n);
  ParallelFor(n, [&](int k) { (*x)[order_[k]] = x_[k]; });
}

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD

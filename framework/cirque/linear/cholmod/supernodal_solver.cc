#ifdef CIRQUE_CHOLMOD

#include "cirque/linear/cholmod/supernodal_solver.h"

#include <algorithm>
#include <cstddef>

#include "cirque/core/parallel.h"

namespace cirque {
namespace {

constexpr int kTogether = SupernodeBlockNumbers::kTogether;
constexpr int kComplex = 2;  ///< parts of a complex number

/// The entries of row i, of kWidth right sides.
template <int kWidth>
double* Row(double* entries, int i) {
  return entries + static_cast<std::size_t>(i) * kWidth;
}

template <int kWidth>
void AddRow(const double* row, double* to) {
  for (int c = 0; c < kWidth; ++c) to[c] += row[c];
}

}  // namespace

SupernodalSolver::SupernodalSolver(const SupernodalTree& tree, const int* order)
    : tree_(tree), order_(order), far_(tree.groups().size()), work_(far_.size()) {}

template <int kWidth, class Numbers>
void SupernodalSolver::Forward(const Numbers& numbers, int s, double* far, Eigen::VectorXd* work) {
  const int rows = tree_.NumRows(s), columns = tree_.NumColumns(s);
  double *x = x_.data(), *w = work->data(), *own = Row<kWidth>(x, tree_.FirstColumn(s));
  // Of a right side of few entries most supernodes have nothing to pass on.
  if (std::all_of(own, Row<kWidth>(own, columns), [](double value) { return value == 0; })) return;
  std::copy(own, Row<kWidth>(own, columns), w);
  std::fill_n(Row<kWidth>(w, columns), (rows - columns + SupernodeNumbers::kPadding) * kWidth, 0.0);
  if constexpr (kWidth == kTogether) {
    numbers.SolveTogether(s, w);
  } else {
    numbers.Solve(s, w);
  }
  std::copy(w, Row<kWidth>(w, columns), own);
  const int* row = tree_.Rows(s);
  const int near = tree_.NumNear(s);
  for (int k = columns; k < near; ++k) AddRow<kWidth>(Row<kWidth>(w, k), Row<kWidth>(x, row[k]));
  for (int k = near; k < rows; ++k) {
    AddRow<kWidth>(Row<kWidth>(w, k), Row<kWidth>(far, tree_.TopNumber(row[k])));
  }
}

template <int kWidth, class Numbers>
void SupernodalSolver::Backward(const Numbers& numbers, int s, Eigen::VectorXd* work) {
  const int rows = tree_.NumRows(s), columns = tree_.NumColumns(s);
  double *x = x_.data(), *w = work->data(), *own = Row<kWidth>(x, tree_.FirstColumn(s));
  std::copy(own, Row<kWidth>(own, columns), w);
  const int* row = tree_.Rows(s);
  for (int k = columns; k < rows; ++k) {
    std::copy_n(Row<kWidth>(x, row[k]), kWidth, Row<kWidth>(w, k));
  }
  std::fill_n(Row<kWidth>(w, rows), SupernodeNumbers::kPadding * kWidth, 0.0);
  if constexpr (kWidth == kTogether) {
    numbers.SolveTogetherTransposed(s, w);
  } else {
    numbers.SolveTransposed(s, w);
  }
  std::copy(w, Row<kWidth>(w, columns), own);
}

template <int kWidth, class Numbers>
void SupernodalSolver::ForwardAll(const Numbers& numbers) {
  const std::vector<int>& top_columns = tree_.top_columns();
  const auto num_top = static_cast<int>(top_columns.size());
  ParallelTasks(static_cast<int>(far_.size()), [&](int g) {
    far_[g].setZero(static_cast<Eigen::Index>(num_top) * kWidth);
    for (const auto& subtrees : tree_.groups()[g]) {
      for (int s = subtrees.begin; s < subtrees.end; ++s) {
        Forward<kWidth>(numbers, s, far_[g].data(), &work_[g]);
      }
    }
  });
  for (Eigen::VectorXd& of_group : far_) {
    for (int k = 0; k < num_top; ++k) {
      AddRow<kWidth>(Row<kWidth>(of_group.data(), k), Row<kWidth>(x_.data(), top_columns[k]));
    }
  }
  for (const int s : tree_.top_supernodes()) Forward<kWidth>(numbers, s, nullptr, &work_.front());
}

template <int kWidth, class Numbers>
void SupernodalSolver::BackwardAll(const Numbers& numbers) {
  for (auto s = tree_.top_supernodes().rbegin(); s != tree_.top_supernodes().rend(); ++s) {
    Backward<kWidth>(numbers, *s, &work_.front());
  }
  ParallelTasks(static_cast<int>(work_.size()), [&](int g) {
    const auto& group = tree_.groups()[g];
    for (auto subtrees = group.rbegin(); subtrees != group.rend(); ++subtrees) {
      for (int s = subtrees->end; s-- > subtrees->begin;) Backward<kWidth>(numbers, s, &work_[g]);
    }
  });
}

void SupernodalSolver::MakeRoom(int width) {
  x_.resize(static_cast<Eigen::Index>(tree_.num_columns()) * width);
  const Eigen::Index most_rows = tree_.most_rows() + SupernodeNumbers::kPadding;
  for (Eigen::VectorXd& work : work_) work.resize(most_rows * width);
}

template <int kWidth, class Vector>
void SupernodalSolver::SolveOne(const SupernodeNumbers& numbers, const Vector& b, Vector* x) {
  using Scalar = typename Vector::Scalar;
  static_assert(kWidth * sizeof(double) == sizeof(Scalar));
  const int n = tree_.num_columns();
  MakeRoom(kWidth);
  auto* entries = reinterpret_cast<Scalar*>(x_.data());
  ParallelFor(n, [&](int k) { entries[k] = b[order_[k]]; });
  ForwardAll<kWidth>(numbers);
  BackwardAll<kWidth>(numbers);
  x->resize(n);
  ParallelFor(n, [&](int k) { (*x)[order_[k]] = entries[k]; });
}

void SupernodalSolver::Solve(const SupernodeNumbers& numbers, const Eigen::VectorXd& b,
                             Eigen::VectorXd* x) {
  SolveOne<1>(numbers, b, x);
}

void SupernodalSolver::Solve(const SupernodeNumbers& numbers, const Eigen::VectorXcd& b,
                             Eigen::VectorXcd* x) {
  SolveOne<kComplex>(numbers, b, x);
}

void SupernodalSolver::SolveTogether(const SupernodeBlockNumbers& numbers, const Eigen::MatrixXd& b,
                                     Eigen::MatrixXd* x) {
  const int n = tree_.num_columns();
  MakeRoom(kTogether);
  x->resize(n, b.cols());
  for (Eigen::Index first = 0; first < b.cols(); first += kTogether) {
    const auto count = static_cast<int>(std::min<Eigen::Index>(kTogether, b.cols() - first));
    x_.setZero();
    ParallelFor(n, [&](int k) {
      double* row = Row<kTogether>(x_.data(), k);
      for (int c = 0; c < count; ++c) row[c] = b(order_[k], first + c);
    });
    ForwardAll<kTogether>(numbers);
    BackwardAll<kTogether>(numbers);
    ParallelFor(n, [&](int k) {
      const double* row = Row<kTogether>(x_.data(), k);
      for (int c = 0; c < count; ++c) (*x)(order_[k], first + c) = row[c];
    });
  }
}

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD

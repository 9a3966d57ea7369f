#ifdef CIRQUE_CHOLMOD

#include "cirque/linear/cholmod/dense_trapezoid.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>

#include <Eigen/Core>

#include "cirque/core/lanes.h"
#include "cirque/core/parallel.h"
#include "cirque/linear/cholmod/blas_calls.h"
#include "cirque/linear/cholmod/column_kernels.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

constexpr int kFewColumns = 8;      ///< up to here our loops are faster than the calls
constexpr int kFewProducts = 64;    ///< columns times inner ones, likewise
constexpr int kFewNumbers = 256;    ///< of a trapezoid that solves for many right sides, likewise
constexpr int kBlockColumns = 128;  ///< of a factorization in parallel
constexpr int kBlockRows = 256;

template <class Scalar>
[[gnu::always_inline]] inline bool FactorFewColumns(const DenseTrapezoid<Scalar>& t) {
  for (int j = 0; j < t.columns; ++j) {
    Scalar* column = t.data + static_cast<std::size_t>(j) * t.rows;
    for (int k = 0; k < j; ++k) {
      const Scalar* before = t.data + static_cast<std::size_t>(k) * t.rows;
      column::AddMultiple(-column::Conjugate(before[j]), before + j, t.rows - j, column + j);
    }
    const double square = std::real(column[j]);
    if (!(square > 0)) return false;
    const double pivot = std::sqrt(square);
    column[j] = pivot;
    column::Scale(1 / pivot, t.rows - j - 1, column + j + 1);
  }
  return true;
}

/// rows := rows L^-* for `count` rows, L the diagonal block of so many columns.
template <class Scalar>
void SolveRows(const Scalar* block, int columns, int leading_dimension, int count, Scalar* rows) {
  blas::SolveOnRight<Scalar>("C", count, columns, {block, leading_dimension},
                             {rows, leading_dimension});
}

/// target := share target + factor product, by BLAS. The target's columns lie
/// `stride` apart.
template <class Scalar>
void AddProduct(const ProductWithTransposed<Scalar>& p, Scalar factor, Scalar share, int stride,
                Scalar* target) {
  blas::MultiplyAdd<Scalar>("N", "C", p.rows, p.columns, p.inner, factor,
                            {p.left, p.leading_dimension}, {p.right, p.leading_dimension}, share,
                            {target, stride});
}

/// Blocks of the columns [begin, end) of a trapezoid behind which the rest of the rows is done.
template <class Scalar>
class BlockColumn {
 public:
  BlockColumn(const DenseTrapezoid<Scalar>& t, int begin)
      : t_(t), begin_(begin), end_(std::min(t.columns, begin + kBlockColumns)) {}

  bool Factor() const {
    if (!blas::Factorize<Scalar>(end_ - begin_, {At(begin_, begin_), t_.rows})) return false;
    ForEachRows(end_, [&](int first, int count) {
      SolveRows(At(begin_, begin_), end_ - begin_, t_.rows, count, At(first, begin_));
    });
    return true;
  }

  /// Takes it out of the columns behind it.
  void SubtractBehind() const {
    for (int column = end_; column < t_.columns; column += kBlockColumns) {
      const int columns = std::min(kBlockColumns, t_.columns - column);
      ForEachRows(column, [&](int first, int count) {
        AddProduct<Scalar>(
            {At(first, begin_), At(column, begin_), t_.rows, count, columns, end_ - begin_}, -1, 1,
            t_.rows, At(first, column));
      });
    }
  }

 private:
  Scalar* At(int row, int column) const {
    return t_.data + static_cast<std::size_t>(column) * t_.rows + row;
  }

  /// Calls body(first, count) for blocks of rows from `begin` on, at once.
  template <class Body>
  void ForEachRows(int begin, const Body& body) const {
    const int blocks = (t_.rows - begin + kBlockRows - 1) / kBlockRows;
    ParallelTasks(blocks, [&](int block) {
      const int first = begin + block * kBlockRows;
      body(first, std::min(kBlockRows, t_.rows - first));
    });
  }

  const DenseTrapezoid<Scalar>& t_;
  int begin_, end_;
};

}  // namespace

template <class Scalar>
bool FactorTrapezoid(const DenseTrapezoid<Scalar>& t) {
  if (t.columns <= kFewColumns) {
    bool positive = true;
    OnWideLanes([&]() __attribute__((always_inline)) { positive = FactorFewColumns(t); });
    return positive;
  }
  if (!blas::Factorize<Scalar>(t.columns, {t.data, t.rows})) return false;
  if (t.rows > t.columns) {
    SolveRows<Scalar>(t.data, t.columns, t.rows, t.rows - t.columns, t.data + t.columns);
  }
  return true;
}

template <class Scalar>
bool FactorTrapezoidInParallel(const DenseTrapezoid<Scalar>& t) {
  for (int begin = 0; begin < t.columns; begin += kBlockColumns) {
    const BlockColumn<Scalar> block(t, begin);
    if (!block.Factor()) return false;
    block.SubtractBehind();
  }
  return true;
}

template <class Scalar>
void SolveWithTrapezoid(const DenseTrapezoid<Scalar>& t, Scalar* w) {
  OnWideLanes([&]() __attribute__((always_inline)) {
    for (int j = 0; j < t.columns; ++j) {
      const Scalar* column = t.data + static_cast<std::size_t>(j) * t.rows;
      const Scalar solved = w[j] /= std::real(column[j]);
      column::AddMultiple(-solved, column + j + 1, t.rows - j - 1, w + j + 1);
    }
  });
}

template <class Scalar>
void SolveWithTrapezoidTransposed(const DenseTrapezoid<Scalar>& t, Scalar* w) {
  OnWideLanes([&]() __attribute__((always_inline)) {
    for (int j = t.columns; j-- > 0;) {
      const Scalar* column = t.data + static_cast<std::size_t>(j) * t.rows;
      w[j] = (w[j] - column::Dot(column + j + 1, w + j + 1, t.rows - j - 1)) / std::real(column[j]);
    }
  });
}

namespace {

using RightSides = Eigen::Array<double, kSolvedTogether, 1>;
using RowOfRightSides = Eigen::Map<RightSides>;

RowOfRightSides RowOf(double* w, int i) {
  return RowOfRightSides(w + static_cast<std::size_t>(i) * kSolvedTogether);
}

bool HasFewNumbers(const DenseTrapezoid<double>& t) { return t.rows * t.columns <= kFewNumbers; }

void SolveTogetherWithFew(const DenseTrapezoid<double>& t, double* w) {
  for (int j = 0; j < t.columns; ++j) {
    const double* column = t.data + static_cast<std::size_t>(j) * t.rows;
    const RightSides solved = RowOf(w, j) / column[j];
    RowOf(w, j) = solved;
    for (int i = j + 1; i < t.rows; ++i) RowOf(w, i) -= column[i] * solved;
  }
}

void SolveTogetherWithFewTransposed(const DenseTrapezoid<double>& t, double* w) {
  for (int j = t.columns; j-- > 0;) {
    const double* column = t.data + static_cast<std::size_t>(j) * t.rows;
    RightSides rest = RowOf(w, j);
    for (int i = j + 1; i < t.rows; ++i) rest -= column[i] * RowOf(w, i);
    RowOf(w, j) = rest / column[j];
  }
}

/// The columns' rows of w become themselves times L^-T, or times L^-1: w seen by columns is its
/// transpose.
void SolveColumnsTogether(const char* transpose, const DenseTrapezoid<double>& t, double* w) {
  blas::SolveOnRight<double>(transpose, kSolvedTogether, t.columns, {t.data, t.rows},
                             {w, kSolvedTogether});
}

}  // namespace

void SolveTogetherWithTrapezoid(const DenseTrapezoid<double>& t, double* w) {
  if (HasFewNumbers(t)) return SolveTogetherWithFew(t, w);
  SolveColumnsTogether("T", t, w);
  const int below = t.rows - t.columns;
  if (below == 0) return;
  blas::MultiplyAdd<double>("N", "T", kSolvedTogether, below, t.columns, -1, {w, kSolvedTogether},
                            {t.data + t.columns, t.rows}, 1,
                            {RowOf(w, t.columns).data(), kSolvedTogether});
}

void SolveTogetherWithTrapezoidTransposed(const DenseTrapezoid<double>& t, double* w) {
  if (HasFewNumbers(t)) return SolveTogetherWithFewTransposed(t, w);
  const int below = t.rows - t.columns;
  if (below > 0) {
    blas::MultiplyAdd<double>("N", "N", kSolvedTogether, t.columns, below, -1,
                              {RowOf(w, t.columns).data(), kSolvedTogether},
                              {t.data + t.columns, t.rows}, 1, {w, kSolvedTogether});
  }
  SolveColumnsTogether("N", t, w);
}

template <class Scalar>
void Multiply(const ProductWithTransposed<Scalar>& p, Scalar* result) {
  if (p.columns * p.inner > kFewProducts) return AddProduct<Scalar>(p, 1, 0, p.rows, result);
  OnWideLanes([&]() __attribute__((always_inline)) {
    for (int c = 0; c < p.columns; ++c) {
      Scalar* column = result + static_cast<std::size_t>(c) * p.rows;
      std::fill_n(column, p.rows, Scalar(0));
      for (int k = 0; k < p.inner; ++k) {
        const std::size_t start = static_cast<std::size_t>(k) * p.leading_dimension;
        column::AddMultiple(column::Conjugate(p.right[start + c]), p.left + start, p.rows, column);
      }
    }
  });
}

template bool FactorTrapezoid(const DenseTrapezoid<double>&);
template bool FactorTrapezoid(const DenseTrapezoid<Complex>&);
template bool FactorTrapezoidInParallel(const DenseTrapezoid<double>&);
template bool FactorTrapezoidInParallel(const DenseTrapezoid<Complex>&);
template void SolveWithTrapezoid(const DenseTrapezoid<double>&, double*);
template void SolveWithTrapezoid(const DenseTrapezoid<Complex>&, Complex*);
template void SolveWithTrapezoidTransposed(const DenseTrapezoid<double>&, double*);
template void SolveWithTrapezoidTransposed(const DenseTrapezoid<Complex>&, Complex*);
template void Multiply(const ProductWithTransposed<double>&, double*);
template void Multiply(const ProductWithTransposed<Complex>&, Complex*);

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD

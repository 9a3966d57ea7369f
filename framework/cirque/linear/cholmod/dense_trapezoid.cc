#ifdef CIRQUE_CHOLMOD

#include "cirque/linear/cholmod/dense_trapezoid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>

#include "cirque/core/lanes.h"
#include "cirque/core/parallel.h"

// NOLINTBEGIN(readability-identifier-naming): the names of BLAS and LAPACK
extern "C" {
void dgemm_(const char* transpose_a, const char* transpose_b, const int* m, const int* n,
            const int* k, const double* alpha, const double* a, const int* lda, const double* b,
            const int* ldb, const double* beta, double* c, const int* ldc);
void dtrsm_(const char* side, const char* uplo, const char* transpose, const char* diagonal,
            const int* m, const int* n, const double* alpha, const double* a, const int* lda,
            double* b, const int* ldb);
void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);
}
// NOLINTEND(readability-identifier-naming)

namespace cirque {
namespace {

constexpr int kFewColumns = 8;      ///< up to here our loops are faster than the calls
constexpr int kFewProducts = 64;    ///< columns times inner ones, likewise
constexpr int kFewNumbers = 256;    ///< of a trapezoid that solves for many right sides, likewise
constexpr int kBlockColumns = 128;  ///< of a factorization in parallel
constexpr int kBlockRows = 256;

bool FactorFewColumns(const DenseTrapezoid& t) {
  for (int j = 0; j < t.columns; ++j) {
    double* column = t.data + static_cast<std::size_t>(j) * t.rows;
    for (int k = 0; k < j; ++k) {
      const double* before = t.data + static_cast<std::size_t>(k) * t.rows;
      const double factor = before[j];
      for (int i = j; i < t.rows; ++i) column[i] -= factor * before[i];
    }
    if (!(column[j] > 0)) return false;
    const double pivot = std::sqrt(column[j]), inverse = 1 / pivot;
    column[j] = pivot;
    for (int i = j + 1; i < t.rows; ++i) column[i] *= inverse;
  }
  return true;
}

bool FactorDiagonalBlock(double* block, int columns, int leading_dimension) {
  int info = 0;
  dpotrf_("L", &columns, block, &leading_dimension, &info);
  return info == 0;
}

/// rows := rows L^-T for `count` rows, L the diagonal block of so many columns.
void SolveRows(const double* block, int columns, int leading_dimension, int count, double* rows) {
  const double one = 1;
  dtrsm_("R", "L", "T", "N", &count, &columns, &one, block, &leading_dimension, rows,
         &leading_dimension);
}

/// target := share target + factor product, by BLAS. The target's columns lie
/// `stride` apart.
void AddProduct(const ProductWithTransposed& p, double factor, double share, int stride,
                double* target) {
  dgemm_("N", "T", &p.rows, &p.columns, &p.inner, &factor, p.left, &p.leading_dimension, p.right,
         &p.leading_dimension, &share, target, &stride);
}

/// Blocks of the columns [begin, end) of a trapezoid behind which the rest of the rows is done.
class BlockColumn {
 public:
  BlockColumn(const DenseTrapezoid& t, int begin)
      : t_(t), begin_(begin), end_(std::min(t.columns, begin + kBlockColumns)) {}

  bool Factor() const {
    if (!FactorDiagonalBlock(At(begin_, begin_), end_ - begin_, t_.rows)) return false;
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
        AddProduct({At(first, begin_), At(column, begin_), t_.rows, count, columns, end_ - begin_},
                   -1, 1, t_.rows, At(first, column));
      });
    }
  }

 private:
  double* At(int row, int column) const {
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

  const DenseTrapezoid& t_;
  int begin_, end_;
};

}  // namespace

bool FactorTrapezoid(const DenseTrapezoid& t) {
  if (t.columns <= kFewColumns) return FactorFewColumns(t);
  if (!FactorDiagonalBlock(t.data, t.columns, t.rows)) return false;
  if (t.rows > t.columns) {
    SolveRows(t.data, t.columns, t.rows, t.rows - t.columns, t.data + t.columns);
  }
  return true;
}

bool FactorTrapezoidInParallel(const DenseTrapezoid& t) {
  for (int begin = 0; begin < t.columns; begin += kBlockColumns) {
    const BlockColumn block(t, begin);
    if (!block.Factor()) return false;
    block.SubtractBehind();
  }
  return true;
}

void SolveWithTrapezoid(const DenseTrapezoid& t, double* w) {
  OnWideLanes([&]() __attribute__((always_inline)) {
    for (int j = 0; j < t.columns; ++j) {
      const double* column = t.data + static_cast<std::size_t>(j) * t.rows;
      const double solved = w[j] /= column[j];
      for (int i = j + 1; i < t.rows; ++i) w[i] -= solved * column[i];
    }
  });
}

namespace {

[[gnu::always_inline]] inline double Dot(const double* a, const double* b, int n) {
  constexpr int kStep = 2 * kLanes;
  Lanes even{}, odd{};
  int i = 0;
  for (; i + kStep <= n; i += kStep) {
    even += lanes::Load(a + i) * lanes::Load(b + i);
    odd += lanes::Load(a + i + kLanes) * lanes::Load(b + i + kLanes);
  }
  even += odd;
  double sum = (even[0] + even[1]) + (even[2] + even[3]);
  for (; i < n; ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

void SolveWithTrapezoidTransposed(const DenseTrapezoid& t, double* w) {
  OnWideLanes([&]() __attribute__((always_inline)) {
    for (int j = t.columns; j-- > 0;) {
      const double* column = t.data + static_cast<std::size_t>(j) * t.rows;
      w[j] = (w[j] - Dot(column + j + 1, w + j + 1, t.rows - j - 1)) / column[j];
    }
  });
}

namespace {

using RightSides = Eigen::Array<double, kSolvedTogether, 1>;
using RowOfRightSides = Eigen::Map<RightSides>;

RowOfRightSides RowOf(double* w, int i) {
  return RowOfRightSides(w + static_cast<std::size_t>(i) * kSolvedTogether);
}

bool HasFewNumbers(const DenseTrapezoid& t) { return t.rows * t.columns <= kFewNumbers; }

void SolveTogetherWithFew(const DenseTrapezoid& t, double* w) {
  for (int j = 0; j < t.columns; ++j) {
    const double* column = t.data + static_cast<std::size_t>(j) * t.rows;
    const RightSides solved = RowOf(w, j) / column[j];
    RowOf(w, j) = solved;
    for (int i = j + 1; i < t.rows; ++i) RowOf(w, i) -= column[i] * solved;
  }
}

void SolveTogetherWithFewTransposed(const DenseTrapezoid& t, double* w) {
  for (int j = t.columns; j-- > 0;) {
    const double* column = t.data + static_cast<std::size_t>(j) * t.rows;
    RightSides rest = RowOf(w, j);
    for (int i = j + 1; i < t.rows; ++i) rest -= column[i] * RowOf(w, i);
    RowOf(w, j) = rest / column[j];
  }
}

/// The columns' rows of w become themselves times L^-T, or times L^-1: w seen by columns is its
/// transpose.
void SolveColumnsTogether(const char* transpose, const DenseTrapezoid& t, double* w) {
  const double one = 1;
  dtrsm_("R", "L", transpose, "N", &kSolvedTogether, &t.columns, &one, t.data, &t.rows, w,
         &kSolvedTogether);
}

}  // namespace

void SolveTogetherWithTrapezoid(const DenseTrapezoid& t, double* w) {
  if (HasFewNumbers(t)) return SolveTogetherWithFew(t, w);
  SolveColumnsTogether("T", t, w);
  const int below = t.rows - t.columns;
  if (below == 0) return;
  const double one = 1, minus_one = -1;
  dgemm_("N", "T", &kSolvedTogether, &below, &t.columns, &minus_one, w, &kSolvedTogether,
         t.data + t.columns, &t.rows, &one, RowOf(w, t.columns).data(), &kSolvedTogether);
}

void SolveTogetherWithTrapezoidTransposed(const DenseTrapezoid& t, double* w) {
  if (HasFewNumbers(t)) return SolveTogetherWithFewTransposed(t, w);
  const int below = t.rows - t.columns;
  const double one = 1, minus_one = -1;
  if (below > 0) {
    dgemm_("N", "N", &kSolvedTogether, &t.columns, &below, &minus_one, RowOf(w, t.columns).data(),
           &kSolvedTogether, t.data + t.columns, &t.rows, &one, w, &kSolvedTogether);
  }
  SolveColumnsTogether("N", t, w);
}

void Multiply(const ProductWithTransposed& p, double* result) {
  if (p.columns * p.inner > kFewProducts) return AddProduct(p, 1, 0, p.rows, result);
  for (int c = 0; c < p.columns; ++c) {
    double* column = result + static_cast<std::size_t>(c) * p.rows;
    std::fill_n(column, p.rows, 0.0);
    for (int k = 0; k < p.inner; ++k) {
      const std::size_t start = static_cast<std::size_t>(k) * p.leading_dimension;
      const double factor = p.right[start + c];
      for (int r = 0; r < p.rows; ++r) column[r] += factor * p.left[start + r];
    }
  }
}

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD

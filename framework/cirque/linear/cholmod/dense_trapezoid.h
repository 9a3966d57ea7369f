#pragma once

#ifdef CIRQUE_CHOLMOD

namespace cirque {

/// The lower trapezoid of a dense matrix, by columns: one supernode of a Cholesky factor.
struct DenseTrapezoid {
  double* data;
  int rows, columns;  ///< rows >= columns; what is above the diagonal does not count
};

/// Overwrites the columns of a symmetric matrix with those of its LL' factor. False, and the
/// numbers undefined, when a pivot is not positive. By LAPACK, but for few columns.
bool FactorTrapezoid(const DenseTrapezoid& trapezoid);

/// The same by blocks of columns, each taken out of those behind it on all cores. The result does
/// not depend on the number of threads.
bool FactorTrapezoidInParallel(const DenseTrapezoid& trapezoid);

/// With L the factor's columns: w of the columns becomes L^-1 w, and is taken out of that of the
/// rows below; w of the columns becomes L^-T w, given that of the rows below.
void SolveWithTrapezoid(const DenseTrapezoid& factored, double* w);
void SolveWithTrapezoidTransposed(const DenseTrapezoid& factored, double* w);

/// The same of so many right sides at once: w has their entries row by row, those of a row side by side.
constexpr int kSolvedTogether = 8;
void SolveTogetherWithTrapezoid(const DenseTrapezoid& factored, double* w);
void SolveTogetherWithTrapezoidTransposed(const DenseTrapezoid& factored, double* w);

/// The product left right', rows x columns, of dense matrices by columns: left has `rows` rows, right
/// `columns`, both `inner` columns and the same leading dimension.
struct ProductWithTransposed {
  const double *left, *right;
  int leading_dimension;
  int rows, columns, inner;
};

/// result = the product, its columns one behind the other. By BLAS, but for few of them.
void Multiply(const ProductWithTransposed& product, double* result);

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD

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

/// product = left right', rows x columns: left has `rows` rows, right `columns`, both `inner`
/// columns and the same leading dimension. By BLAS, but for few of them.
void MultiplyByTransposed(const double* left, const double* right, int leading_dimension, int rows,
                          int columns, int inner, double* product);

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD

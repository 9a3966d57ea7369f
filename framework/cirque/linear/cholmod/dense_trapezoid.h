#pragma once

#ifdef CIRQUE_CHOLMOD

namespace cirque {

/// The lower trapezoid of a dense matrix, by columns: one supernode of a Cholesky factor. Its numbers
/// are double or std::complex<double>.
template <class Scalar>
struct DenseTrapezoid {
  Scalar* data;
  int rows, columns;  ///< rows >= columns; what is above the diagonal does not count
};

/// Overwrites the columns of a Hermitian matrix with those of its LL* factor. False, and the
/// numbers undefined, when a pivot is not positive. By LAPACK, but for few columns.
template <class Scalar>
bool FactorTrapezoid(const DenseTrapezoid<Scalar>& trapezoid);

/// The same by blocks of columns, each taken out of those behind it on all cores. The result does
/// not depend on the number of threads.
template <class Scalar>
bool FactorTrapezoidInParallel(const DenseTrapezoid<Scalar>& trapezoid);

/// With L the factor's columns: w of the columns becomes L^-1 w, and is taken out of that of the
/// rows below; w of the columns becomes L^-* w, given that of the rows below.
template <class Scalar>
void SolveWithTrapezoid(const DenseTrapezoid<Scalar>& factored, Scalar* w);
template <class Scalar>
void SolveWithTrapezoidTransposed(const DenseTrapezoid<Scalar>& factored, Scalar* w);

/// The same of so many right sides at once: w has their entries row by row, those of a row side by side.
constexpr int kSolvedTogether = 8;
void SolveTogetherWithTrapezoid(const DenseTrapezoid<double>& factored, double* w);
void SolveTogetherWithTrapezoidTransposed(const DenseTrapezoid<double>& factored, double* w);

/// The product left right*, rows x columns, of dense matrices by columns: left has `rows` rows, right
/// `columns`, both `inner` columns and the same leading dimension.
template <class Scalar>
struct ProductWithTransposed {
  const Scalar *left, *right;
  int leading_dimension;
  int rows, columns, inner;
};

/// result = the product, its columns one behind the other. By BLAS, but for few of them.
template <class Scalar>
void Multiply(const ProductWithTransposed<Scalar>& product, Scalar* result);

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD

#pragma once

#ifdef CIRQUE_CHOLMOD

#include <complex>

// NOLINTBEGIN(readability-identifier-naming): the names of BLAS and LAPACK
extern "C" {
void dgemm_(const char* transpose_a, const char* transpose_b, const int* m, const int* n,
            const int* k, const double* alpha, const double* a, const int* lda, const double* b,
            const int* ldb, const double* beta, double* c, const int* ldc);
void zgemm_(const char* transpose_a, const char* transpose_b, const int* m, const int* n,
            const int* k, const std::complex<double>* alpha, const std::complex<double>* a,
            const int* lda, const std::complex<double>* b, const int* ldb,
            const std::complex<double>* beta, std::complex<double>* c, const int* ldc);
void dtrsm_(const char* side, const char* uplo, const char* transpose, const char* diagonal,
            const int* m, const int* n, const double* alpha, const double* a, const int* lda,
            double* b, const int* ldb);
void ztrsm_(const char* side, const char* uplo, const char* transpose, const char* diagonal,
            const int* m, const int* n, const std::complex<double>* alpha,
            const std::complex<double>* a, const int* lda, std::complex<double>* b, const int* ldb);
void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);
void zpotrf_(const char* uplo, const int* n, std::complex<double>* a, const int* lda, int* info);
}
// NOLINTEND(readability-identifier-naming)

/// Dense matrices by columns, real and complex: "C" transposes and conjugates.
namespace cirque::blas {

/// A matrix, the first entry of which stands at `data`, its columns so many entries apart.
template <class Scalar>
struct Columns {
  Scalar* data;
  int apart;
};

/// c = beta c + alpha op(a) op(b), m x n, by k inner ones.
template <class Scalar>
inline void MultiplyAdd(const char* op_a, const char* op_b, int m, int n, int k, Scalar alpha,
                        Columns<const Scalar> a, Columns<const Scalar> b, Scalar beta,
                        Columns<Scalar> c) {
  if constexpr (sizeof(Scalar) == sizeof(double)) {
    dgemm_(op_a, op_b, &m, &n, &k, &alpha, a.data, &a.apart, b.data, &b.apart, &beta, c.data,
           &c.apart);
  } else {
    zgemm_(op_a, op_b, &m, &n, &k, &alpha, a.data, &a.apart, b.data, &b.apart, &beta, c.data,
           &c.apart);
  }
}

/// b = b op(l)^-1, m x n, l lower triangular.
template <class Scalar>
inline void SolveOnRight(const char* op, int m, int n, Columns<const Scalar> l, Columns<Scalar> b) {
  const Scalar one = 1;
  if constexpr (sizeof(Scalar) == sizeof(double)) {
    dtrsm_("R", "L", op, "N", &m, &n, &one, l.data, &l.apart, b.data, &b.apart);
  } else {
    ztrsm_("R", "L", op, "N", &m, &n, &one, l.data, &l.apart, b.data, &b.apart);
  }
}

/// The lower triangle of a becomes that of its Cholesky factor. False when a pivot is not positive.
template <class Scalar>
inline bool Factorize(int n, Columns<Scalar> a) {
  int info = 0;
  if constexpr (sizeof(Scalar) == sizeof(double)) {
    dpotrf_("L", &n, a.data, &a.apart, &info);
  } else {
    zpotrf_("L", &n, a.data, &a.apart, &info);
  }
  return info == 0;
}

}  // namespace cirque::blas

#endif  // CIRQUE_CHOLMOD

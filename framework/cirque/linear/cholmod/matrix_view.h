#pragma once

#ifdef CIRQUE_CHOLMOD

#include <cstddef>
#include <type_traits>

#include <Eigen/SparseCore>
#include <cholmod.h>

namespace cirque {

/// A CHOLMOD view of the lower triangle of a symmetric or Hermitian matrix: no copy.
template <class Scalar>
cholmod_sparse ViewOf(const Eigen::SparseMatrix<Scalar>& lower) {
  cholmod_sparse view = {};
  view.nrow = static_cast<std::size_t>(lower.rows());
  view.ncol = static_cast<std::size_t>(lower.cols());
  view.nzmax = static_cast<std::size_t>(lower.nonZeros());
  view.p = const_cast<int*>(lower.outerIndexPtr());
  view.i = const_cast<int*>(lower.innerIndexPtr());
  view.x = const_cast<Scalar*>(lower.valuePtr());
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = std::is_same_v<Scalar, double> ? CHOLMOD_REAL : CHOLMOD_COMPLEX;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD

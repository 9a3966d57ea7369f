#include "cirque/layout/sliding.h"

#include <array>
#include <cmath>
#include <utility>

#include "cirque/linear/registry.h"
#include "cirque/math/predicates.h"

namespace cirque {

std::complex<double> Rail::Move(std::complex<double> z, double distance) const {
  if (!IsCircle()) return z + distance * direction;
  const std::complex<double> moved = z * std::polar(1.0, distance);
  return moved / std::abs(moved);
}

bool RimEdge::RunsBetween(std::complex<double> from, std::complex<double> to) const {
  if (direction != 0.0) return std::real(std::conj(direction) * (to - from)) > 0;
  return OrientationSign({0, 0}, {from.real(), from.imag()}, {to.real(), to.imag()}) > 0;
}

SlidingCholesky::SlidingCholesky(const std::vector<Rail>& rails, Index unknowns)
    : rail_(unknowns, kNone), first_(unknowns), cholesky_(MakeCholesky()) {
  for (std::size_t r = 0; r < rails.size(); ++r) rail_[rails[r].vertex] = static_cast<Index>(r);
  for (Index v = 0; v < unknowns; ++v) {
    first_[v] = size_;
    size_ += Slides(v) ? 1 : 2;
  }
}

/// Of conj(x_i) value x_j the real part, in the real unknowns; i = j: value is real.
void SlidingCholesky::AddEntry(Index i, Index j, Complex value,
                               std::vector<Eigen::Triplet<double>>* entries) const {
  const std::array<Complex, 2> units = {1.0, Complex(0, 1)};
  for (int k = 0; k < (Slides(i) ? 1 : 2); ++k) {
    const Complex row = Slides(i) ? tangents_[rail_[i]] : units[k];
    for (int l = 0; l < (Slides(j) ? 1 : 2); ++l) {
      if (i == j && l > k) continue;
      const Complex column = Slides(j) ? tangents_[rail_[j]] : units[l];
      entries->emplace_back(first_[i] + k, first_[j] + l,
                            std::real(std::conj(row) * value * column));
    }
  }
}

bool SlidingCholesky::Factorize(const ComplexSparseMatrix& lower, std::vector<Complex> tangents) {
  tangents_ = std::move(tangents);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * static_cast<std::size_t>(lower.nonZeros()));
  for (int j = 0; j < lower.cols(); ++j) {
    for (ComplexSparseMatrix::InnerIterator it(lower, j); it; ++it) {
      AddEntry(static_cast<Index>(it.row()), j, it.value(), &entries);
    }
  }
  SparseMatrix real(size_, size_);
  real.setFromTriplets(entries.begin(), entries.end());
  return cholesky_->Factorize(real);
}

Eigen::VectorXcd SlidingCholesky::Solve(const Eigen::VectorXcd& b) const {
  Eigen::VectorXd right(size_);
  for (Eigen::Index v = 0; v < b.size(); ++v) {
    const Index at = first_[v];
    if (Slides(static_cast<Index>(v))) {
      right[at] = std::real(std::conj(tangents_[rail_[v]]) * b[v]);
    } else {
      right.segment<2>(at) << b[v].real(), b[v].imag();
    }
  }
  const Eigen::VectorXd x = cholesky_->Solve(right);
  Eigen::VectorXcd result(b.size());
  for (Eigen::Index v = 0; v < b.size(); ++v) {
    const Index at = first_[v];
    result[v] =
        Slides(static_cast<Index>(v)) ? x[at] * tangents_[rail_[v]] : Complex(x[at], x[at + 1]);
  }
  return result;
}

}  // namespace cirque

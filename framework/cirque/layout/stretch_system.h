#pragma once

#include <array>
#include <complex>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "cirque/layout/beltrami_system.h"
#include "cirque/layout/step_system.h"
#include "cirque/layout/stretch_energy.h"
#include "cirque/layout/stretch_sum.h"
#include "cirque/linear/sparse_cholesky.h"
#include "cirque/linear/sparse_matrix.h"

namespace cirque {

/// A stretch energy's sum over the faces of a part, and its projected Newton steps: the Hessian of
/// each face without its negative eigenvalues. Written in the moduli of a = f_z and b = f_zbar, the
/// energy e(|a|, |b|) has the eigenvalues (B. Smith, F. de Goes, T. Kim, "Analytic eigensystems for
/// isotropic distortion energies", ACM TOG 38(1), 2019; here without singular vectors)
///   e_a / |a|  for turns of a,   e_b / |b|  for turns of b,
/// and those of the 2 x 2 matrix of second derivatives for changes of the moduli. (A. Shtengel, R.
/// Poranne, O. Sorkine-Hornung, S. Kovalsky, Y. Lipman, "Geometric optimization via composite
/// majorization", ACM TOG 36(4), 2017, have another convex model from the same two numbers.)
///
/// That sees more than holomorphic changes, so the matrix is real, with two unknowns for a vertex
/// that moves and one for a vertex that slides along a rail.
///
/// A part's fence adds its barrier, whose contacts come and go with the steps.
class StretchSystem final : public StepSystem {
 public:
  /// `part` must outlive the system.
  StretchSystem(const MapPart& part, const StretchEnergy& energy, double unit);

  double Value(const Eigen::VectorXcd& z) const override;
  bool Factorize(const Eigen::VectorXcd& z, double shift) override;
  Eigen::VectorXcd Solve(const Eigen::VectorXcd& right_side) const override;
  const Eigen::VectorXcd& gradient() const override { return gradient_; }
  const Eigen::VectorXd& penalty() const override { return penalty_; }

  /// A share of the way to where the first triangle would have no area, by the roots of its area, a
  /// quadratic polynomial in the length of the step (Smith, Schaefer 2015).
  double LongestStep(const Eigen::VectorXcd& z, const Eigen::VectorXcd& direction) const override;

  /// What Factorize factors, by its lower triangle; unknowns by FirstUnknown.
  void Linearize(const Eigen::VectorXcd& z, double shift);
  const SparseMatrix& lower() const { return lower_; }
  /// Of a moving vertex, the number of its real part, or of its way along a rail; the imaginary part
  /// follows.
  Index FirstUnknown(Index vertex) const { return first_[vertex]; }

 private:
  using Complex = std::complex<double>;
  /// A real linear function of some vertices' changes, Re(sum conj(w_k) dz_k), by its coefficients at
  /// their unknowns: two a vertex.
  template <int kVertices>
  using Row = std::array<double, 2 * kVertices>;
  template <int kVertices>
  using Slots = std::array<int, kVertices*(2 * kVertices + 1)>;

  template <int kVertices>
  Row<kVertices> RowOf(const std::array<Index, kVertices>& vertex,
                       const std::array<Complex, kVertices>& w) const;
  template <int kVertices>
  void AddRow(const Slots<kVertices>& slots, const Row<kVertices>& row, double curvature);
  template <int kVertices>
  Slots<kVertices> FindSlots(const std::array<Index, kVertices>& vertex) const;

  std::array<Index, 2> UnknownsOf(Index vertex) const;
  void NumberUnknowns();
  void LayOutPattern();
  void FindAllSlots();
  int Slot(Index i, Index j) const;
  double AddFace(std::size_t face, const Eigen::VectorXcd& z);
  void AddPenalty(std::size_t seam, double stiffness);
  void FindContacts(const Eigen::VectorXcd& z);
  void AddContact(std::size_t contact);

  const MapPart& part_;
  const StretchEnergy energy_;
  const double unit_;
  Index size_ = 0;              ///< unknowns
  std::vector<Index> first_;    ///< per vertex that moves
  std::vector<Index> rail_;     ///< per vertex that moves: among the part's, or kNone
  std::vector<Complex> frame_;  ///< per vertex that moves: what the first unknown goes along
  SparseMatrix lower_;
  std::vector<Slots<3>> face_slots_;
  std::vector<Slots<4>> seam_slots_;
  std::vector<Contact> contacts_;  ///< of the part's fence
  std::vector<Slots<3>> contact_slots_;
  std::vector<std::array<Index, 3>> foreseen_;  ///< the contacts in the pattern, sorted
  Eigen::VectorXcd gradient_;
  Eigen::VectorXd penalty_;
  std::unique_ptr<SparseCholesky> cholesky_;
};

}  // namespace cirque

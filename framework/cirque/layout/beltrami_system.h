#pragma once

#include <array>
#include <complex>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/types.h"
#include "cirque/layout/fence.h"
#include "cirque/layout/map_objective.h"
#include "cirque/layout/sliding.h"
#include "cirque/linear/hermitian_cholesky.h"

namespace cirque {

/// A face of a map that has a complex number z_i per vertex. The map's derivatives on it are
///   f_zbar = sum z_i G_i,   f_z = sum z_i conj(G_i)
/// up to one factor, with G_i the gradient of vertex i's hat function on a triangle similar to the
/// surface's; the G_i sum to zero.
struct BeltramiFace {
  std::array<Index, 3> vertex;
  double weight;  ///< in the mean over all faces; 0: no area on the surface, no part in the mean
  std::array<std::complex<double>, 3> hat;
  /// That factor, for derivatives by lengths on the surface scaled to area 1.
  double scale = 0;
};

/// |mu|^2 = |f_zbar / f_z|^2 of a face.
double SquaredBeltrami(const BeltramiFace& face, const Eigen::VectorXcd& z);

/// That the two sides of an edge on a seam differ by the seam's rotation: of four vertices,
/// (z_0 - z_1) - e^{i rotation} (z_2 - z_3) = 0.
struct SeamConstraint {
  std::array<Index, 4> vertex;  ///< right tip, right tail, left tip, left tail
  std::array<std::complex<double>, 4> factor;
  Index left_face, right_face;  ///< kNone: without area

  /// The left side of the equation at z.
  std::complex<double> operator()(const Eigen::VectorXcd& z) const;
};

/// A moving vertex that is drawn to a place: a stretch energy gains weight |z - to|^2.
struct Pull {
  Index vertex;
  std::complex<double> to;
  double weight;
};

/// Some vertices of a map and all that their places matter to. Vertices and faces are numbered as
/// they stand here.
struct MapPart {
  std::vector<Index> vertex;                    ///< the map's number of each; held ones stand last
  Index unknowns = 0;                           ///< how many are free to move
  std::vector<std::array<Index, 3>> triangles;  ///< the faces, counter-clockwise
  std::vector<BeltramiFace> faces;              ///< those with a weight, their vertices increasing
  std::vector<SeamConstraint> seams;
  std::vector<Rail> rails;   ///< of the moving vertices that slide, in their order; none with seams
  std::vector<RimEdge> rim;  ///< at those
  std::vector<Pull> pulls = {};
  std::optional<Fence> fence = {};  ///< steps may not cross; its barrier is of stretch energies
};

/// The objective's sum over the faces of a part, and the Hermitian matrices of its Gauss-Newton
/// steps in the vertices that move.
class BeltramiSystem {
 public:
  /// `part` must outlive the system.
  BeltramiSystem(const MapPart& part, const MapObjective& objective);

  /// sum_f weight_f value(|mu_f|^2), infinite where some |mu| >= 1. z: of all of the part's vertices.
  double Value(const Eigen::VectorXcd& z) const;

  /// The linear model at z: gradient = sum A w conj(J) mu, and the lower triangle of
  /// sum A w J* J + C* P C, with A a face's weight, w the objective's, J = d mu / d z, C the seam
  /// constraints and P = diag(penalty), which outweighs the faces at each seam. Each diagonal entry
  /// is then raised by `shift` of itself, for translations and similarities: entries differ by
  /// twenty-eight orders of magnitude. @pre Value(z) is finite.
  void Linearize(const Eigen::VectorXcd& z, double shift);

  const MapPart& part() const { return part_; }
  const Eigen::VectorXcd& gradient() const { return gradient_; }
  const Eigen::VectorXd& penalty() const { return penalty_; }
  const ComplexSparseMatrix& lower() const { return lower_; }

 private:
  using Complex = std::complex<double>;
  static constexpr int kHeld = -1;  ///< the slot of an entry that is none: a vertex does not move

  void LayOutPattern();
  void FindSlots();
  int Slot(Index i, Index j) const;
  double AddFace(std::size_t face, const Eigen::VectorXcd& z);
  void AddPenalty(std::size_t seam, double stiffness);

  const MapPart& part_;
  const MapObjective objective_;
  ComplexSparseMatrix lower_;
  /// Where the entries go among the values of `lower_`: of faces (0,0) (1,1) (2,2) (1,0) (2,0) (2,1),
  /// of seams all sixteen.
  std::vector<std::array<int, 6>> face_slots_;
  std::vector<std::array<int, 16>> seam_slots_;
  Eigen::VectorXcd gradient_;
  Eigen::VectorXd penalty_;
};

}  // namespace cirque

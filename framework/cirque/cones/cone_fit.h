#pragma once

#include <map>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "cirque/cones/cone.h"
#include "cirque/cones/cone_measure.h"
#include "cirque/cones/cone_problem.h"
#include "cirque/cones/curvature_program.h"

namespace cirque {

/// Cones at chosen vertices of a problem and what its linear model says of their curvatures:
///   u = u_0 + sum_c mu_c g_c,
/// u_0 the log scale without cones and g_c the response to a unit of curvature at c. A cone costs one
/// solve with the problem's factor, whatever is done with its curvature after; the products g_c' M g_d are
/// made when they are asked for, of many cones together.
class ConeFit {
 public:
  /// `measure` is what the fits lower; null: area distortion.
  explicit ConeFit(const ConeProblem& problem, std::unique_ptr<ConeMeasure> measure = nullptr);

  int size() const { return static_cast<int>(vertices_.size()); }
  const std::vector<Index>& vertices() const { return vertices_; }
  const Eigen::VectorXd& curvature() const { return curvature_; }  ///< of each cone [rad]
  /// g_c' M g_d: the Hessian of the measure's form 1/2 u' M u by the curvatures; of area distortion
  /// sum_v a_v g_c g_d.
  const Eigen::MatrixXd& Gram();

  /// Solves ahead, and together, for what cones at these candidates do; until the next call, Add and Move
  /// to one of them take no solve.
  void Prepare(const std::vector<Index>& vertices);

  /// A cone more, of curvature 0. @pre a candidate of the problem.
  void Add(Index vertex);
  /// Moves cone i to another vertex; its curvature stays until it is fitted.
  void Move(int i, Index vertex);
  /// Takes the last move back, and the curvatures that it began with.
  void UndoMove();

  /// The admissible curvatures of least 1/2 u' M u. False, and nothing changes, when admissible
  /// curvatures cannot add up to 2 pi chi on a closed surface.
  bool FitLeastSquares();

  /// The same with no curvature at cone i.
  bool FitWithout(int i);

  /// The curvatures that make u one constant at all cones (0 with a boundary): every cone keeps its
  /// scale, as when a map is made by cutting through the cones (R. Sawhney, K. Crane, "Boundary
  /// first flattening", 2017). They need not be admissible. O(n^2) for n cones of which the last is new.
  void FitZeroAtCones();

  /// u, V: the sum above, of many cones by one solve.
  Eigen::VectorXd LogScale() const;

  /// sqrt(u' M u), without making u; of area distortion sqrt(sum_v a_v u_v^2).
  double Distortion();

  /// The derivative of 1/2 u' M u by the curvature of every vertex, up to one constant on a closed
  /// surface: the factor's answer to M u. Where it differs from its value at the cones, a cone
  /// would help.
  Eigen::VectorXd Descent() const;

  /// The measure itself, of the present curvatures.
  double Measure() const { return measure_->Value(LogScale()); }

  /// Makes M touch the measure at the present curvatures (ConeMeasure::AdaptTo). False when nothing
  /// changed.
  bool AdaptMeasure();

  std::vector<Cone> Cones() const;

 private:
  CurvatureProgram Program();
  bool Fit(const CurvatureProgram& program);
  void SetResponse(int i, Index vertex);
  void MakeProducts();
  void ForgetValuesFrom(int i);
  bool FactorValuesAtCones();
  double ValueAtCone(Eigen::Index of, Eigen::Index at) const;
  bool FitZeroByFactor();
  void FitZeroByElimination();

  struct MoveRecord {
    int cone = 0;
    Index vertex = kNone;
    ConeProblem::Response response;
    Eigen::VectorXd curvature;
    Eigen::VectorXd gram;  ///< of the cone with all
    double linear = 0;
  };

  const ConeProblem& problem_;
  const std::unique_ptr<ConeMeasure> measure_;
  const Eigen::VectorXd& without_cones_;
  double constant_;  ///< u_0' M u_0
  std::vector<Index> vertices_;
  std::vector<ConeProblem::Response> response_;
  std::map<Index, ConeProblem::Response> prepared_;
  Eigen::MatrixXd gram_;    ///< products of the responses by M
  Eigen::VectorXd linear_;  ///< of the responses with u_0
  /// L L' = the responses' values at the cones, of a closed surface those of moving curvature there from
  /// the first: its rows for the cones that were there at the last call of FitZeroAtCones.
  Eigen::MatrixXd values_factor_;
  int values_factored_ = 0;            ///< rows
  std::vector<int> without_products_;  ///< cones whose rows of both are still to be made
  Eigen::VectorXd curvature_;
  MoveRecord last_move_;
};

}  // namespace cirque

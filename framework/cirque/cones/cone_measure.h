#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/cones/cone_problem.h"
#include "cirque/core/enum_words.h"

namespace cirque {

enum class ConeMeasureKind { kArea, kAngle };

template <>
inline constexpr auto kEnumWords<ConeMeasureKind> = std::to_array<EnumWord<ConeMeasureKind>>(
    {{ConeMeasureKind::kArea, "area"}, {ConeMeasureKind::kAngle, "angle"}});

/// What cones are to lower, as a measure of the log scale u (V) of the linear model and a quadratic
/// form 1/2 u' M u that stands for it where the curvatures of cones are fitted.
class ConeMeasure {
 public:
  virtual ~ConeMeasure() = default;

  /// M u. On a closed surface its entries add up to 0 for u of mean 0.
  virtual Eigen::VectorXd Apply(const Eigen::VectorXd& u) const = 0;

  /// The same of several u, as the columns of a matrix.
  using Columns = std::vector<const Eigen::VectorXd*>;
  virtual Eigen::MatrixXd ApplyToAll(const Columns& u) const;

  virtual double Value(const Eigen::VectorXd& u) const = 0;

  /// What lies at each vertex of that which Value adds up (V).
  virtual Eigen::VectorXd Shares(const Eigen::VectorXd& u) const = 0;

  /// Makes the form touch the measure at u: what lowers the form from there lowers the measure.
  /// False when the form is the measure squared everywhere and nothing changed.
  virtual bool AdaptTo(const Eigen::VectorXd& /*u*/) { return false; }
};

/// Area distortion: sqrt(sum_v a_v u_v^2), which is AreaNorm.
class AreaMeasure final : public ConeMeasure {
 public:
  explicit AreaMeasure(const ConeProblem& problem) : area_(problem.area()) {}
  Eigen::VectorXd Apply(const Eigen::VectorXd& u) const override { return area_.cwiseProduct(u); }
  double Value(const Eigen::VectorXd& u) const override;
  Eigen::VectorXd Shares(const Eigen::VectorXd& u) const override;

 private:
  const Eigen::VectorXd& area_;
};

/// Angle distortion: the mean of s/t - 1 over the source's triangles, s >= t the singular values of
/// the map that is linear on each, predicted to first order: with circumradius R_f and area a_f
/// (total 1)
///   sum_f a_f R_f |grad u|_f.
/// The smooth conformal map of log scale u + x . grad u is z + c z^2 / 2 at its circumcentre, |c| =
/// |grad u|, up to a similarity; its linear interpolation at three points of |z| = R has a
/// coefficient of conj(z) of modulus |c| R / 2 whatever the three points are (z^2 is sigma_1 z -
/// sigma_2 + sigma_3 / z there, by the polynomial of the three, and 1 / z = conj(z) / R^2). No
/// other discrete map that is conformal where it can be does better with the same cones: this much
/// comes of triangles being straight.
///
/// The form is sum_f w_f a_f R_f^2 |grad u|_f^2 with weights 1 at first, then those of iteratively
/// reweighted least squares, 1 / sqrt((R_f |grad u|_f)^2 + delta^2), which majorise the measure
/// smoothed by delta. R is at most 4 times the longest side and areas at least 1e-3 of its square.
class AngleMeasure final : public ConeMeasure {
 public:
  explicit AngleMeasure(const ConeProblem& problem);
  Eigen::VectorXd Apply(const Eigen::VectorXd& u) const override;
  Eigen::MatrixXd ApplyToAll(const Columns& u) const override;
  double Value(const Eigen::VectorXd& u) const override;
  Eigen::VectorXd Shares(const Eigen::VectorXd& u) const override;
  bool AdaptTo(const Eigen::VectorXd& u) override;

 private:
  void ApplyTogether(const Columns& u, std::size_t first, std::size_t end,
                     Eigen::MatrixXd* result) const;
  double Predicted(Index f, const Eigen::VectorXd& u) const;
  template <class Weight>
  void SetStiffness(const Weight& weight);

  const Triangulation& triangulation_;
  Eigen::VectorXd area_;       ///< F, total 1
  Eigen::VectorXd side_;       ///< 3F: of (R |grad u|)^2 by squared differences along the sides
  Eigen::VectorXd stiffness_;  ///< E: of the form, by squared differences along the edges
  std::vector<std::array<Index, 2>> ends_;  ///< E: the edges'
  double delta_ = 0;
};

std::unique_ptr<ConeMeasure> MakeConeMeasure(ConeMeasureKind kind, const ConeProblem& problem);

}  // namespace cirque

#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/cones/boundary_problem.h"
#include "cirque/core/option_table.h"
#include "cirque/core/registry.h"
#include "cirque/core/status.h"

namespace cirque {

/// How the prediction of a shape is to be descended from by the finished metric: to the least realised
/// L^p norm of the log scale.
struct BoundaryDescent {
  int steps = 0;      ///< the most; 0: the boundary stays as predicted
  int power = 2;      ///< p
  double filter = 1;  ///< of sum len^2 (b_i - b_j)^2, in the model by which steps are chosen
};

/// What a boundary shall look like in the plane: a prediction of the angle sums of its vertices by
/// the linear model, which the circle pattern then has exactly (docs/mathematics.md, Boundaries).
class BoundaryShape {
 public:
  virtual ~BoundaryShape() = default;

  /// Angle sums [rad], V, within the problem's bounds and of its total to the last digits
  /// (Gauss-Bonnet); 0 inside. Settles what is beyond bounds. Errors (invalid input): the bounds
  /// leave no such sums, a file that cannot be read.
  virtual StatusOr<Eigen::VectorXd> Choose(BoundaryProblem* problem) const = 0;

  virtual BoundaryDescent descent() const { return {}; }
};

/// Makes a shape from its options; errors name the option, its value and its bound.
using BoundaryShapeFactory =
    std::function<StatusOr<std::shared_ptr<const BoundaryShape>>(const OptionMap&)>;

/// The table of shapes, one line an entry:
///   isometric   the boundary keeps its lengths up to one factor, u = 0 there: least max |u| of all
///               smooth maps (B. Springborn, P. Schroeder, U. Pinkall, 2008), and the default of
///               Boundary First Flattening (2017)
///   least_area  least area-weighted L2 norm of u: of u = u_0 + H b by conjugate gradients in b,
///               with a little of sum len^2 (b_i - b_j)^2 along the boundary against noise
///   least_max   the same of the L^p norm, p = 8
///   straight    straight but for corners that turn alike, where the isometric boundary has turned
///               by equal parts
///   given       the boundary's angle sums of a cone file
const Registry<BoundaryShapeFactory>& BoundaryShapes();

/// The shape that a text means, "least_area:share=0.25". Errors (invalid input): an unknown name, with
/// all that are known; options that are unknown or out of bounds; a text that is no name with options.
StatusOr<std::shared_ptr<const BoundaryShape>> ParseBoundaryShape(const std::string& text);

/// The boundary that the angle fit chooses: the option's text for none of the shapes.
inline constexpr char kFreeBoundary[] = "free";

/// That and the names of the shapes.
std::vector<std::string> BoundaryNames();

/// Whether the text is that, or names a shape.
Status CheckBoundaryShape(const std::string& text);

}  // namespace cirque

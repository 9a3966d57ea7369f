#include "cirque/angles/angle_program.h"

#include <algorithm>
#include <vector>

#include "cirque/math/compensated_sum.h"

namespace cirque {
namespace {

constexpr double kRoom = 0.05;  ///< [rad]: what InteriorPoint leaves to every inequality

}  // namespace

AngleProgram::AngleProgram(const AngleFitProblem& problem, const AngleObjective& objective)
    : constraints_(problem.constraints), objective_(objective) {
  const Triangulation& t = constraints_.triangulation();
  for (int row = t.num_faces(); row < constraints_.num_rows(); ++row) {
    if (constraints_.Lower(row) < constraints_.Upper(row)) ranged_row_.push_back(row);
  }
  const int angles = t.num_halfedges(), variables = angles + static_cast<int>(ranged_row_.size());
  slope_ = weight_ = centre_ = Eigen::VectorXd::Zero(variables);
  partner_.assign(variables, kNone);
  for (Index h = 0; h < angles; ++h) {
    centre_[h] = objective.ClampReference(problem.reference[h], problem.epsilon);
    partner_[h] = t.twin[h];
  }
  for (const Index h : t.edge_halfedge) {
    const EdgeMargins margins = MarginsOf(problem, objective, h);
    if (margins.theta >= 0) AddEdge(h, t.twin[h], margins);
  }
  for (int i = angles; i < variables; ++i) AddRange(i, ranged_row_[i - angles]);
  Linearize(centre_);
}

void AngleProgram::Linearize(const Eigen::VectorXd& x) {
  const int angles = constraints_.triangulation().num_halfedges();
  const auto size = static_cast<std::size_t>(angles);
  std::vector<ScalarJet> jets(size);
  objective_.Distances({centre_.data(), size}, {x.data(), size}, jets);
  value_ = ParallelSum(angles, [&](Index h) {
    const ScalarJet& jet = jets[h];
    slope_[h] = jet.slope;
    weight_[h] = jet.curvature;
    return jet.value;
  });
}

void AngleProgram::AddEdge(Index l, Index r, const EdgeMargins& margins) {
  inequalities_.push_back({l, kNone, 1, margins.l});
  if (r != kNone) inequalities_.push_back({r, kNone, 1, margins.r});
  inequalities_.push_back({l, r, -1, margins.theta - kPi});
}

void AngleProgram::AddRange(int variable, int row) {
  centre_[variable] = 0.5 * (constraints_.Lower(row) + constraints_.Upper(row));
  inequalities_.push_back({variable, kNone, 1, constraints_.Lower(row)});
  inequalities_.push_back({variable, kNone, -1, -constraints_.Upper(row)});
}

Eigen::VectorXd AngleProgram::ApplyB(const Eigen::VectorXd& x) const {
  const int angles = constraints_.triangulation().num_halfedges();
  Eigen::VectorXd sums = constraints_.Apply(x.head(angles));
  for (std::size_t i = 0; i < ranged_row_.size(); ++i) {
    sums[ranged_row_[i]] -= x[angles + static_cast<int>(i)];
  }
  return sums;
}

Eigen::VectorXd AngleProgram::EqualityResidual(const Eigen::VectorXd& x) const {
  Eigen::VectorXd residual = ApplyB(x);
  for (int row = 0; row < constraints_.num_rows(); ++row) {
    // The right side of a ranged row is 0.
    if (constraints_.Lower(row) == constraints_.Upper(row))
      residual[row] -= constraints_.Lower(row);
  }
  return residual;
}

Eigen::VectorXd AngleProgram::ApplyTransposedB(const Eigen::VectorXd& y) const {
  const int angles = constraints_.triangulation().num_halfedges();
  Eigen::VectorXd slopes(num_variables());
  for (Index h = 0; h < angles; ++h) slopes[h] = constraints_.Slope(y.data(), h);
  for (int i = angles; i < num_variables(); ++i) slopes[i] = -y[ranged_row_[i - angles]];
  return slopes;
}

Eigen::VectorXd AngleProgram::ApplyG(const Eigen::VectorXd& x) const {
  Eigen::VectorXd values(num_inequalities());
  for (int k = 0; k < num_inequalities(); ++k) {
    const Inequality& c = inequalities_[k];
    values[k] = c.sign * (x[c.i] + (c.j == kNone ? 0 : x[c.j]));
  }
  return values;
}

Eigen::VectorXd AngleProgram::Slacks(const Eigen::VectorXd& x) const {
  Eigen::VectorXd slacks = ApplyG(x);
  for (int k = 0; k < num_inequalities(); ++k) slacks[k] -= inequalities_[k].bound;
  return slacks;
}

Eigen::VectorXd AngleProgram::ApplyTransposedG(const Eigen::VectorXd& z) const {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(num_variables());
  for (int k = 0; k < num_inequalities(); ++k) {
    const Inequality& c = inequalities_[k];
    values[c.i] += c.sign * z[k];
    if (c.j != kNone) values[c.j] += c.sign * z[k];
  }
  return values;
}

Eigen::VectorXd AngleProgram::InteriorPoint() const {
  Eigen::VectorXd x = centre_;
  const int angles = constraints_.triangulation().num_halfedges();
  for (Index h = 0; h < angles; ++h) {
    x[h] = std::clamp(x[h], kRoom, partner_[h] == kNone ? kPi - kRoom : 0.5 * (kPi - kRoom));
  }
  return x;
}

AngleProgram::Blocks::Blocks(const AngleProgram& program, const Eigen::VectorXd& q)
    : program_(program),
      own_(program.weight_),
      shared_(Eigen::VectorXd::Zero(program.num_variables())) {
  for (int k = 0; k < program.num_inequalities(); ++k) {
    const Inequality& c = program.inequalities_[k];
    if (c.j == kNone) {
      own_[c.i] += q[k];
    } else {
      shared_[c.i] = shared_[c.j] = q[k];
    }
  }
}

/// Of [[a + t, t], [t, b + t]]: no cancellation, however large t is.
double AngleProgram::Blocks::Determinant(int i, int j) const {
  return own_[i] * own_[j] + shared_[i] * (own_[i] + own_[j]);
}

Eigen::VectorXd AngleProgram::Blocks::Solve(const Eigen::VectorXd& v) const {
  Eigen::VectorXd x(v.size());
  for (int i = 0; i < v.size(); ++i) {
    const int j = program_.partner_[i];
    x[i] = j == kNone ? v[i] / own_[i]
                      : (own_[j] * v[i] + shared_[i] * (v[i] - v[j])) / Determinant(i, j);
  }
  return x;
}

Eigen::VectorXd AngleProgram::Blocks::ApplyGToSolution(const Eigen::VectorXd& v,
                                                       const Eigen::VectorXd& x) const {
  Eigen::VectorXd values = program_.ApplyG(x);
  for (int k = 0; k < program_.num_inequalities(); ++k) {
    const Inequality& c = program_.inequalities_[k];
    if (c.j == kNone) continue;
    values[k] = c.sign * (own_[c.j] * v[c.i] + own_[c.i] * v[c.j]) / Determinant(c.i, c.j);
  }
  return values;
}

void AngleProgram::Blocks::NormalMatrix(EdgeBlockAssembler* assembler, SparseMatrix* lower) const {
  const int angles = program_.constraints_.triangulation().num_halfedges();
  EdgeBlockAssembler& matrix = *assembler;
  matrix.Clear();
  for (Index i = 0; i < angles; ++i) {
    const int j = program_.partner_[i];
    if (j == kNone) {
      matrix.Add(i, i, 1 / own_[i]);
      continue;
    }
    const double determinant = Determinant(i, j);
    matrix.Add(i, i, (own_[j] + shared_[i]) / determinant);
    matrix.Add(i, j, -shared_[i] / determinant);
  }
  for (int i = angles; i < program_.num_variables(); ++i) {
    matrix.AddToDiagonal(program_.ranged_row_[i - angles], 1 / own_[i]);
  }
  matrix.AssembleAgain(lower);
}

}  // namespace cirque

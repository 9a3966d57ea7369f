#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/registry.h"
#include "cirque/energy/registry.h"

#include "experiments/common/high_precision.h"

namespace cirque::audit_energies {

/// A point at which an energy is audited.
struct AuditPoint {
  std::string name;  ///< what is fragile about it
  Eigen::VectorXd x;
  /// The length over which the energy is smooth around x, well inside its domain: Taylor remainders
  /// are taken from this step down.
  double step = 0;
};

/// An energy's input with points inside the energy's domain and outside.
struct AuditCase {
  std::string name;
  std::shared_ptr<const EnergyInput> input;
  std::vector<AuditPoint> inside, outside;
};

/// An energy's value in 50 digits and the sum of the magnitudes of its terms, which says how much
/// of it rounding may take.
struct ReferenceValue {
  high_precision::Real value = 0, magnitude = 0;
};

using Reals = std::vector<high_precision::Real>;

/// Computes the energy of that input at x from its definition, by other formulas than the energy's.
using Reference = std::function<ReferenceValue(const EnergyInput&, const Reals& x)>;

/// What the audit of one energy needs.
struct AuditSamples {
  std::vector<AuditCase> cases;
  Reference reference;
};

using SampleMaker = std::function<AuditSamples()>;

/// One check's outcome: its worst figure over all points.
struct Finding {
  std::string check;
  bool applies = true;  ///< false: the energy claims nothing that this check could refute
  double figure = 0;    ///< an error, at most `bound` if all is well
  double bound = 0;
  std::string where;  ///< of the worst figure: case, point and what was compared

  bool ok() const { return figure <= bound; }

  /// Keeps the worse of what it has and this figure. A NaN is the worst of all.
  void Note(double new_figure, const std::string& new_where);
};

/// All checks of one energy. The energies of the cases are made by `factory`.
///   gradient   E(x + hp) - E(x) - h g.p falls as h^2: figure = 2 - observed order
///   hessian    E(x + hp) - E(x) - h g.p - h^2/2 p.Hp falls as h^3, and g(x + hp) - g(x) - h Hp as
///              h^2: figure = the larger shortfall of the observed orders
///   digits     value, gradient and Hessian against 50 digits: relative errors
///   symmetry   the Hessian's entries lie in the lower triangle, and the gradient's derivative is
///              symmetric: q.(dg along p) = p.(dg along q)
///   convexity  -lambda_min / lambda_max of the Hessian without the gauge's rows; for energies that
///              claim convexity
///   forms      Gradient() is Evaluate's; residuals have r'r/2 = E + constant and J'r = gradient
///   (or r
///              = gradient, J = Hessian)
///   domain     every form refuses points outside the domain, NaN and infinity included: the number
///   of
///              calls that did not
std::vector<Finding> AuditEnergy(const EnergyFactory& factory, const AuditSamples& samples);

/// The findings of one energy, or why there are none.
struct AuditRow {
  std::string energy;
  Status status;
  std::vector<Finding> findings;

  bool ok() const;
};

/// Audits every energy of the registry; one without samples has a row whose status says so.
std::vector<AuditRow> AuditRegistry(const Registry<EnergyFactory>& energies,
                                    const Registry<SampleMaker>& samples);

/// The samples of the framework's own energies, one line an entry in samples.cc.
const Registry<SampleMaker>& Samples();

}  // namespace cirque::audit_energies

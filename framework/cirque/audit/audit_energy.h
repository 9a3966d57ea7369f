#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/status.h"
#include "cirque/energy/energy.h"

namespace cirque {

/// A point at which an energy is audited.
struct AuditPoint {
  std::string name;   ///< what is usual or fragile about it
  Eigen::VectorXd x;  ///< n parameters
  /// The length over which the energy is smooth around x, well inside its domain: Taylor remainders
  /// are taken from this step down. Of a point outside the domain any.
  double step = 0;
  /// The sum of the magnitudes of the energy's terms at x, which says how much of the value rounding
  /// may take; 0: |E(x)|, right where the terms have one sign.
  double magnitude = 0;
};

/// An energy with points inside its domain and outside.
struct AuditCase {
  std::string name;
  std::shared_ptr<const Energy> energy;
  std::vector<AuditPoint> inside, outside;

  /// "NAME, POINT: what": the place of a finding.
  std::string Where(const AuditPoint& point, const std::string& what) const {
    return name + ", " + point.name + ": " + what;
  }
};

/// One check's outcome: its worst figure over all cases and points.
struct AuditFinding {
  std::string check;
  bool applies = true;  ///< false: the energy claims nothing that this check could refute
  double figure = 0;    ///< an error, at most `bound` if all is well
  double bound = 0;
  std::string where;  ///< of the worst figure: case, point and what was compared

  bool ok() const { return figure <= bound; }

  /// Keeps the worse of what it has and this figure. A NaN is the worst of all.
  void Note(double new_figure, const std::string& new_where);
};

/// One thing that is checked of an energy: `run` notes its figures for one case.
struct AuditCheck {
  std::string name;
  double bound;
  std::function<void(const AuditCase&, AuditFinding*)> run;
};

/// What can be checked of any energy, in this order:
///   gradient   E(x + hp) - E(x) - h g.p falls as h^2: figure = 2 - observed order
///   hessian    E(x + hp) - E(x) - h g.p - h^2/2 p.Hp falls as h^3, and
///              g(x + hp) - g(x) - h Hp as h^2: figure = the larger shortfall of the observed orders
///   symmetry   the Hessian's entries lie in the lower triangle, and the gradient's derivative is
///              symmetric: q.(dg along p) = p.(dg along q)
///   convexity  -lambda_min / lambda_max of the Hessian, with and without the gauge's rows; for
///              energies that claim convexity
///   forms      Gradient() is Evaluate's; residuals have r'r/2 = E + constant and J'r = gradient
///              (or r = gradient, J = Hessian)
///   domain     every form refuses points outside the domain, NaN and infinity included: the number
///              of calls that did not
const std::vector<AuditCheck>& AuditChecks();

/// Judges an energy, registered or a user's own, at the points of the cases: a finding a check, in
/// the order of `checks`. Sound when all findings are ok() and each that applies has a `where` (it
/// looked at something). The energies must be of one kind; points need NumParameters() entries.
std::vector<AuditFinding> AuditEnergy(const std::vector<AuditCase>& cases,
                                      const std::vector<AuditCheck>& checks = AuditChecks());

/// The findings of one energy by name, or why there are none.
struct AuditRow {
  std::string energy;
  Status status;
  std::vector<AuditFinding> findings;

  bool ok() const;
};

/// Whether there are rows and none failed.
bool AllOk(const std::vector<AuditRow>& rows);

/// A table energy x check, each entry "ok", "-" (does not apply) or the worst figure, then a line
/// for each failure: what was compared, where, figure and bound.
std::string ToText(const std::vector<AuditRow>& rows);

/// The same with every figure. Figures that are no number are null.
std::string ToJson(const std::vector<AuditRow>& rows);

}  // namespace cirque

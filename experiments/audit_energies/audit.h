#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cirque/audit/audit_energy.h"
#include "cirque/core/registry.h"
#include "cirque/energy/registry.h"

#include "experiments/common/high_precision.h"

namespace cirque::audit_energies {

/// An energy's input with points inside the energy's domain and outside.
struct SampleCase {
  std::string name;
  std::shared_ptr<const EnergyInput> input;
  std::vector<AuditPoint> inside, outside;
};

/// An energy's value in 50 digits and the sum of the magnitudes of its terms.
struct ReferenceValue {
  high_precision::Real value = 0, magnitude = 0;
};

using Reals = std::vector<high_precision::Real>;

/// Computes the energy of that input at x from its definition, by other formulas than the energy's.
using Reference = std::function<ReferenceValue(const EnergyInput&, const Reals& x)>;

/// What the audit of one registered energy needs.
struct AuditSamples {
  std::vector<SampleCase> cases;
  Reference reference;
};

using SampleMaker = std::function<AuditSamples()>;

/// AuditChecks() and, after the derivatives,
///   digits     value, gradient and Hessian against 50 digits: relative errors
/// `samples` must outlive them.
std::vector<AuditCheck> ChecksWithDigits(const AuditSamples& samples);

/// All those checks of the energies that `factory` makes of the cases' inputs.
std::vector<AuditFinding> AuditSampled(const EnergyFactory& factory, const AuditSamples& samples);

/// Audits every energy of the registry; one without samples has a row whose status says so.
std::vector<AuditRow> AuditRegistry(const Registry<EnergyFactory>& energies,
                                    const Registry<SampleMaker>& samples);

/// The samples of the framework's own energies, one line an entry in samples.cc.
const Registry<SampleMaker>& Samples();

}  // namespace cirque::audit_energies

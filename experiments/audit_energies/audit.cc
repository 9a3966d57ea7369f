#include "experiments/audit_energies/audit.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "experiments/audit_energies/checks.h"

namespace cirque::audit_energies {

void Finding::Note(double new_figure, const std::string& new_where) {
  const bool is_worse = where.empty() || !(new_figure <= figure);
  if (!is_worse || std::isnan(figure)) return;
  figure = new_figure;
  where = new_where;
}

std::vector<Finding> AuditEnergy(const EnergyFactory& factory, const AuditSamples& samples) {
  std::vector<std::unique_ptr<const Energy>> energies;
  for (const AuditCase& c : samples.cases) energies.push_back(factory(*c.input));
  std::vector<Finding> findings;
  for (const Check& check : Checks()) {
    Finding finding;
    finding.check = check.name;
    finding.bound = check.bound;
    for (std::size_t i = 0; i < energies.size(); ++i) {
      check.run({*energies[i], samples.cases[i], samples.reference}, &finding);
    }
    findings.push_back(finding);
  }
  return findings;
}

bool AuditRow::ok() const {
  return status.ok() && !findings.empty() &&
         std::all_of(findings.begin(), findings.end(), [](const Finding& f) { return f.ok(); });
}

namespace {

AuditRow AuditOne(const std::string& name, const EnergyFactory& factory,
                  const Registry<SampleMaker>& table) {
  AuditRow row{name, {}, {}};
  const StatusOr<SampleMaker> maker = table.Find(name);
  if (!maker.ok()) {
    row.status = Status::InvalidInput(fmt::format(
        "energy '{}' is registered but has no samples to audit it with: add a line to the table in "
        "experiments/audit_energies/samples.cc",
        name));
    return row;
  }
  const AuditSamples samples = (*maker)();
  const auto has_points = [](const AuditCase& c) { return !c.inside.empty(); };
  if (!std::any_of(samples.cases.begin(), samples.cases.end(), has_points) || !samples.reference) {
    row.status = Status::InvalidInput(
        fmt::format("the samples of energy '{}' have no points or no 50-digit reference", name));
    return row;
  }
  row.findings = AuditEnergy(factory, samples);
  return row;
}

}  // namespace

std::vector<AuditRow> AuditRegistry(const Registry<EnergyFactory>& energies,
                                    const Registry<SampleMaker>& samples) {
  std::vector<AuditRow> rows;
  for (const std::string& name : energies.Names()) {
    rows.push_back(AuditOne(name, *energies.Find(name), samples));
  }
  return rows;
}

}  // namespace cirque::audit_energies

// At which inputs and points the framework's energies are audited: usual ones and fragile ones.
#include "experiments/audit_energies/samples.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "cirque/energy/angle_constraints.h"
#include "cirque/energy/conformal_equivalence_energy.h"

namespace cirque::audit_energies {
namespace {

using Eigen::VectorXd;

constexpr double kSliver = 1e-6;

SampleCase CaseOf(std::string name, EnergyInput input) {
  return {std::move(name), std::make_shared<const EnergyInput>(std::move(input)), {}, {}};
}

/// Log radii with the length over which the energy is smooth there: an edge's curvature has a peak
/// of width theta at d = 0, which a step must not cross.
AuditPoint RadiiPoint(const std::string& name, const EnergyInput& input, const VectorXd& rho) {
  const Triangulation& t = input.triangulation;
  double step = 0.1;
  for (const Index h : t.edge_halfedge) {
    const Index g = t.twin[h];
    if (g == kNone) continue;
    const double theta = kPi - input.coherent.value[h] - input.coherent.value[g];
    const double d = rho[Triangulation::Face(h)] - rho[Triangulation::Face(g)];
    step = std::min(step, 0.1 * std::max(theta, std::abs(d)));
  }
  return {name, rho, step};
}

SampleCase CirclePatternCase(const std::string& name, double opposite) {
  EnergyInput input = DiskInput(1);
  const int n = input.triangulation.num_faces();
  if (opposite > 0) input.coherent.value = PairedAngles(input.triangulation, opposite);
  SampleCase c = CaseOf(name, std::move(input));
  Random random(5);
  const auto add = [&](const std::string& point, double size) {
    c.inside.push_back(RadiiPoint(point, *c.input, random.Vector(n, size)));
  };
  add("radii all equal", 0);
  add("|d| about 1", 1);
  // Much nearer to d = 0, where odd derivatives vanish, remainders of third and fourth order
  // cancel.
  add("|d| about 1e-6", 1e-6);
  add("|d| up to 20", 10);
  add("|d| up to 600", 300);
  add("|d| up to 20000", 1e4);
  return c;
}

AuditSamples CirclePatternSamples() {
  return {{CirclePatternCase("round triangles", 0),
           CirclePatternCase("nearly cocircular", (kPi - kSliver) / 2),
           CirclePatternCase("needles", kSliver)},
          CirclePatternReference};
}

/// `spread`: lengths are multiplied by e^-spread to e^spread at random, so that many triangles are
/// none.
SampleCase EquivalenceCase(const std::string& name, EnergyInput input, double spread) {
  Random random(11);
  for (double& length : input.lengths.value) length *= std::exp(random.Uniform(-spread, spread));
  const auto n = static_cast<int>(TargetsOfScales(input.targets).angle_sum.size());
  SampleCase c = CaseOf(name, std::move(input));
  for (const double size : {0.0, 0.3, 3.0, 10.0}) {
    c.inside.push_back({fmt::format("|u| up to {}", size), random.Vector(n, size), 1e-3});
  }
  return c;
}

SampleMaker EquivalenceSamplesOf(bool delaunay) {
  return [delaunay]() -> AuditSamples {
    return {{EquivalenceCase("disk", DiskInput(2), 0), EquivalenceCase("sphere", SphereInput(3), 0),
             EquivalenceCase("no triangles", SphereInput(4), 3)},
            EquivalenceReference(delaunay)};
  };
}

SampleCase BarrierCase(const std::string& name, const VectorXd& reference) {
  EnergyInput input = DiskInput(2);
  const Triangulation& t = input.triangulation;
  if (reference.size() > 0) input.reference.value = reference;
  std::vector<AuditPoint> inside = {
      {"round triangles", RoundAngles(t, 3), 0.03},
      {"theta tiny", PairedAngles(t, (kPi - kSliver) / 2), 0.1 * kSliver},
      {"angles tiny", PairedAngles(t, kSliver), 0.1 * kSliver}};
  std::vector<AuditPoint> outside = {{"theta negative", PairedAngles(t, kPi / 2 + kSliver), 0}};
  for (const double angle : {0.0, -kSliver, -1.0, kPi + kSliver}) {
    outside.push_back({"one angle out of range", RoundAngles(t, 3), 0});
    outside.back().x[4] = angle;
  }
  SampleCase c = CaseOf(name, std::move(input));
  c.inside = std::move(inside);
  c.outside = std::move(outside);
  return c;
}

AuditSamples BarrierSamples() {
  const Triangulation t = DiskInput(2).triangulation;
  return {{BarrierCase("measured references", {}),
           BarrierCase("references not Delaunay", PairedAngles(t, 2.5)),
           BarrierCase("references of needles", PairedAngles(t, kSliver))},
          CoherentAngleBarrierReference};
}

SampleCase DualCase(const std::string& name, EnergyInput input) {
  const int n = AngleConstraints(input.triangulation, input.targets).num_rows();
  SampleCase c = CaseOf(name, std::move(input));
  Random random(7);
  c.inside = {{"small multipliers", random.Vector(n, 0.05), 1e-3},
              {"multipliers about 1", random.Vector(n, 1), 1e-3},
              {"multipliers up to 30", random.Vector(n, 30), 1e-3},
              {"slopes all below", VectorXd::Constant(n, -5) + random.Vector(n, 0.1), 1e-3}};
  return c;
}

SampleMaker DualSamplesOf(const std::string& objective) {
  return [objective]() -> AuditSamples {
    const EnergyInput measured = DiskInput(4);
    EnergyInput not_delaunay = measured, needles = measured, cones = measured;
    not_delaunay.reference.value = PairedAngles(measured.triangulation, 2.5);
    needles.reference.value = PairedAngles(measured.triangulation, 1e-4);
    // Cones: ranged inside; every vertex constrained, so that there is a gauge.
    const std::vector<Index> corners =
        AngleConstraints(cones.triangulation, cones.targets).corners();
    for (std::size_t v = 0; v < corners.size(); ++v) {
      cones.targets.lower[v] = 0.3 * corners[v];
      cones.targets.upper[v] = v % 2 == 0 ? cones.targets.lower[v] : 2.5 * corners[v];
    }
    return {{DualCase("measured references", measured),
             DualCase("references not Delaunay", not_delaunay),
             DualCase("references of needles", needles), DualCase("ranged cones", cones)},
            DualReference(objective)};
  };
}

SampleCase LorentzCase(const std::string& name, double scale) {
  EnergyInput input = PointsInput(30, scale, 9);
  const Eigen::Vector3d v = input.points.front(), w = input.points.back();
  const Eigen::Vector3d side = Random(6).UnitVector();
  SampleCase c = CaseOf(name, std::move(input));
  c.inside = {
      {"the centre", VectorXd::Zero(3), 0.03},  {"near the centre", 1e-5 * side, 0.03},
      {"half way out", 0.5 * side, 0.03},       {"at the sphere", (1 - 1e-6) * side, 1e-8},
      {"before a point", (1 - 1e-3) * v, 1e-6}, {"just before a point", (1 - 1e-6) * w, 1e-9}};
  c.outside = {{"on the sphere", VectorXd::Unit(3, 1), 0},
               {"outside the sphere", 1.001 * side, 0},
               {"far outside", 1e200 * side, 0}};
  return c;
}

AuditSamples LorentzSamples() {
  return {{LorentzCase("spread points", 3), LorentzCase("crowd of 1e-3", 1e-3),
           LorentzCase("crowd of 1e-8", 1e-8)},
          LorentzReference};
}

}  // namespace

const Registry<SampleMaker>& Samples() {
  static const Registry<SampleMaker> kTable(
      "energy with samples", {
                                 {"circle_pattern", CirclePatternSamples},
                                 {"coherent_angle_barrier", BarrierSamples},
                                 {"conformal_equivalence", EquivalenceSamplesOf(true)},
                                 {"conformal_equivalence_fixed", EquivalenceSamplesOf(false)},
                                 {"lorentz", LorentzSamples},
                                 {"quadratic_dual", DualSamplesOf("quadratic")},
                                 {"weighted_quadratic_dual", DualSamplesOf("weighted_quadratic")},
                                 {"barrier_dual", DualSamplesOf("barrier")},
                                 {"entropy_dual", DualSamplesOf("entropy")},
                                 {"least_squares_dual", DualSamplesOf("least_squares")},
                             });
  return kTable;
}

}  // namespace cirque::audit_energies

#include <cmath>
#include <utility>

#include <glog/logging.h>

#include "cirque/generators/generators.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/mesh/preflight.h"

#include "experiments/audit_energies/samples.h"

namespace cirque::audit_energies {

double Random::Uniform(double low, double high) {
  return low + (high - low) * std::ldexp(static_cast<double>(engine_()), -32);
}

Eigen::VectorXd Random::Vector(int n, double size) {
  Eigen::VectorXd x(n);
  for (double& entry : x) entry = Uniform(-size, size);
  return x;
}

Eigen::Vector3d Random::UnitVector() {
  Eigen::Vector3d v;
  do {
    v = Vector(3, 1);
  } while (v.norm() > 1 || v.norm() < 0.1);
  return v.normalized();
}

namespace {

/// A small generated mesh with its measured angles and lengths.
EnergyInput GeneratedInput(const std::string& generator, unsigned seed) {
  const StatusOr<PolygonSoup> soup = GenerateMesh(generator, {24, seed});
  CHECK(soup.ok()) << soup.status().message();
  PreflightReport report;
  const StatusOr<Surface> surface = Preflight(*soup, &report);
  CHECK(surface.ok()) << surface.status().message();
  EnergyInput input;
  input.triangulation = surface->triangulation;
  input.lengths = MeasureEdgeLengths(*surface);
  input.reference = MeasureSurface(input.triangulation, input.lengths).angles;
  input.coherent.value = RoundAngles(input.triangulation, seed);
  input.targets = FreeBoundaryTargets(input.triangulation);
  return input;
}

}  // namespace

EnergyInput DiskInput(unsigned seed) { return GeneratedInput("bumpy_terrain", seed); }

EnergyInput SphereInput(unsigned seed) {
  EnergyInput input = GeneratedInput("sphere", seed);
  const double each = kPi * input.triangulation.num_faces() / input.triangulation.num_vertices;
  Random random(seed);
  Eigen::VectorXd sum = random.Vector(input.triangulation.num_vertices, 0.5 * each);
  sum.array() += each - sum.mean();
  input.targets.lower.assign(sum.begin(), sum.end());
  input.targets.upper = input.targets.lower;
  return input;
}

Eigen::VectorXd RoundAngles(const Triangulation& t, unsigned seed) {
  Random random(seed);
  Eigen::VectorXd angles(t.num_halfedges());
  for (Index f = 0; f < t.num_faces(); ++f) {
    const double a = random.Uniform(0.8, 1.3), b = random.Uniform(0.8, 1.3);
    angles.segment<3>(3 * f) << a, b, kPi - a - b;
  }
  return angles;
}

Eigen::VectorXd PairedAngles(const Triangulation& t, double opposite) {
  Eigen::VectorXd angles = Eigen::VectorXd::Constant(t.num_halfedges(), kPi / 3);
  std::vector<bool> is_paired(t.num_faces(), false);
  for (const Index h : t.edge_halfedge) {
    const Index g = t.twin[h];
    if (g == kNone || is_paired[Triangulation::Face(h)] || is_paired[Triangulation::Face(g)]) {
      continue;
    }
    for (const Index corner : {h, g}) {
      is_paired[Triangulation::Face(corner)] = true;
      angles.segment<3>(3 * Triangulation::Face(corner)).setConstant((kPi - opposite) / 2);
      angles[corner] = opposite;
    }
  }
  return angles;
}

EnergyInput PointsInput(int n, double scale, unsigned seed) {
  Random random(seed);
  EnergyInput input;
  const Eigen::Vector3d centre = random.UnitVector();
  for (int i = 0; i < n; ++i) {
    input.points.push_back((centre + scale * random.UnitVector()).normalized());
    input.weights.push_back(random.Uniform(0.2, 2));
  }
  return input;
}

}  // namespace cirque::audit_energies

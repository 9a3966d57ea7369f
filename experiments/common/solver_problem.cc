#include "experiments/common/solver_problem.h"

#include <filesystem>
#include <numbers>
#include <random>

#include "cirque/angles/angle_fit.h"
#include "cirque/angles/registry.h"
#include "cirque/energy/dual_angle_energy.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/io/io.h"
#include "cirque/mesh/preflight.h"

namespace cirque {
namespace {

/// Unit vectors from the centre of mass to the vertices.
std::vector<Eigen::Vector3d> Directions(const Surface& surface) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : surface.position) centre += p;
  centre /= static_cast<double>(surface.position.size());
  std::vector<Eigen::Vector3d> directions;
  for (const Eigen::Vector3d& p : surface.position) directions.push_back((p - centre).normalized());
  return directions;
}

/// Flat vertices; those of a closed surface share what Gauss-Bonnet asks of them:
///   sum_v (2 pi - target_v) = 2 pi chi.
ConeTargets EvenTargets(const Triangulation& t) {
  ConeTargets targets = FreeBoundaryTargets(t);
  if (t.num_edges() * 2 != t.num_halfedges()) return targets;
  const double target =
      2 * std::numbers::pi * (1 - static_cast<double>(EulerCharacteristic(t)) / t.num_vertices);
  targets.lower.assign(t.num_vertices, target);
  targets.upper = targets.lower;
  return targets;
}

Status FitCoherentAngles(EnergyInput* input) {
  const AngleConstraints constraints(input->triangulation, input->targets);
  AngleFitResult fit;
  Status status =
      FitAngles({constraints, input->reference.value, input->epsilon},
                *AngleObjectives().Find("quadratic"), **MakeAngleSolver("newton"), {}, &fit);
  input->coherent = std::move(fit.angles);
  input->epsilon = input->coherent.epsilon;
  return status;
}

constexpr double kNearby = 0.1;
constexpr int kMostHalvings = 30;

/// Inside the domain, where `x` is.
Eigen::VectorXd NearPoint(const Energy& energy, const Eigen::VectorXd& x) {
  std::mt19937 random(1);
  Eigen::VectorXd direction(x.size());
  for (double& entry : direction) {
    entry = 2 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1;
  }
  double length = kNearby, value;
  for (int i = 0; i < kMostHalvings; ++i, length /= 2) {
    const Eigen::VectorXd near = x + length * direction;
    if (energy.Evaluate(near.data(), &value, nullptr)) return near;
  }
  return x;
}

}  // namespace

StatusOr<std::shared_ptr<const StudyProblem>> MakeProblem(const std::string& name,
                                                          const Surface& surface, double epsilon) {
  auto problem = std::make_shared<StudyProblem>();
  problem->mesh = name;
  EnergyInput& input = problem->input;
  input.triangulation = surface.triangulation;
  input.targets = EvenTargets(surface.triangulation);
  input.epsilon = epsilon;
  input.lengths = MeasureEdgeLengths(surface);
  input.reference = MeasureSurface(surface.triangulation, input.lengths).angles;
  input.points = Directions(surface);
  input.weights.assign(input.points.size(), 1.0 / static_cast<double>(input.points.size()));
  if (Status s = FitCoherentAngles(&input); !s.ok()) return s.In(name);
  return std::shared_ptr<const StudyProblem>(std::move(problem));
}

StatusOr<std::shared_ptr<const StudyProblem>> LoadProblem(const std::string& path) {
  const StatusOr<PolygonSoup> soup = ReadMesh(path);
  if (!soup.ok()) return soup.status();
  PreflightReport report;
  const StatusOr<Surface> surface = Preflight(*soup, &report);
  if (!surface.ok()) return surface.status().In(path);
  return MakeProblem(std::filesystem::path(path).stem().string(), *surface);
}

Eigen::VectorXd StartOf(const Energy& energy, const EnergyInput& input) {
  Eigen::VectorXd start = Eigen::VectorXd::Zero(energy.NumParameters());
  double value;
  const bool starts_at_zero = energy.Evaluate(start.data(), &value, nullptr);
  return starts_at_zero ? start : input.coherent.value;
}

const Registry<EnergyStart>& EnergyStarts() {
  static const Registry<EnergyStart> kTable(
      "start of an energy",
      {
          {"own", [](const Energy& energy, const EnergyInput& input,
                     const Eigen::VectorXd&) { return StartOf(energy, input); }},
          {"solution", [](const Energy&, const EnergyInput&,
                          const Eigen::VectorXd& minimizer) { return minimizer; }},
          {"near", [](const Energy& energy, const EnergyInput&,
                      const Eigen::VectorXd& minimizer) { return NearPoint(energy, minimizer); }},
      });
  return kTable;
}

Eigen::VectorXd ComparableSolution(const Energy& energy, const Eigen::VectorXd& x) {
  if (const auto* dual = dynamic_cast<const DualAngleEnergy*>(&energy)) {
    return dual->Angles(x.data());
  }
  const std::vector<int> gauge = energy.GaugeParameters();
  return gauge.empty() ? x : Eigen::VectorXd(x.array() - x[gauge.front()]);
}

}  // namespace cirque

#include "energies.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cirque/audit/audit_energy.h"
#include "cirque/energy/registry.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/solver/solver_strategy.h"

#include "own.h"
#include "run.h"

namespace cirque::python {
namespace {

/// An energy of the library with all that it is made from.
struct LibraryEnergy {
  std::shared_ptr<EnergyInput> input;
  std::shared_ptr<const Energy> energy;
};

/// What a circle pattern's energy takes for granted.
void CheckCoherent(const Triangulation& t, const Eigen::VectorXd& angles) {
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    const double other = t.IsBoundaryEdge(e) ? 0 : angles[t.twin[h]];
    const bool positive = angles[h] > 0 && (t.IsBoundaryEdge(e) || other > 0);
    if (positive && angles[h] + other < kPi) continue;
    throw StatusError(Status::InvalidInput(
        "the angles are not coherent: all must be positive, and the two opposite the edge between "
        "the "
        "vertices " +
        std::to_string(t.Tail(h)) + " and " + std::to_string(t.Tip(h)) +
        " (counted from 0) add up to less than pi; a flat mesh is to be strictly Delaunay"));
  }
}

/// Of a surface whose own angles are coherent angles, or are taken for them.
LibraryEnergy MakeLibraryEnergy(const std::string& name, const PreparedMesh& mesh,
                                const std::optional<Eigen::VectorXd>& angles) {
  if (mesh.num_components() > 1) {
    throw StatusError(Status::InvalidInput("an energy is of one component; the mesh has " +
                                           std::to_string(mesh.num_components())));
  }
  const std::shared_ptr<const Surface> whole = mesh.surface();
  const Surface& surface = *whole;
  auto input = std::make_shared<EnergyInput>();
  input->triangulation = surface.triangulation;
  input->lengths = MeasureEdgeLengths(surface);
  input->reference = MeasureCornerAngles(surface.triangulation, input->lengths);
  input->coherent.value = angles ? *angles : input->reference.value;
  if (input->coherent.value.size() != input->reference.value.size()) {
    throw py::value_error("angles: one a corner is needed, 3 F in all");
  }
  if (name == "circle_pattern") CheckCoherent(input->triangulation, input->coherent.value);
  input->targets = FreeBoundaryTargets(surface.triangulation);
  input->points.reserve(surface.position.size());
  for (const Eigen::Vector3d& x : surface.position) input->points.push_back(x.normalized());
  input->weights.assign(input->points.size(), 1.0);
  const EnergyFactory factory = ValueOf(Energies().Find(name));
  std::shared_ptr<const Energy> energy = factory(*input);
  return {std::move(input), std::move(energy)};
}

void CheckSize(const Energy& energy, const Eigen::VectorXd& x) {
  if (x.size() == energy.NumParameters()) return;
  throw py::value_error("x has " + std::to_string(x.size()) + " entries; num_parameters is " +
                        std::to_string(energy.NumParameters()));
}

/// As a Python energy answers.
py::object Evaluate(const LibraryEnergy& own, const Eigen::VectorXd& x) {
  CheckSize(*own.energy, x);
  double value;
  Eigen::VectorXd gradient(x.size());
  if (!own.energy->Evaluate(x.data(), &value, gradient.data())) return py::none();
  return py::make_tuple(value, gradient);
}

py::object Hessian(const LibraryEnergy& own, const Eigen::VectorXd& x) {
  CheckSize(*own.energy, x);
  SparseMatrix lower;
  if (!own.energy->Hessian(x.data(), &lower)) return py::none();
  std::vector<int> rows, columns;
  std::vector<double> values;
  for (int j = 0; j < lower.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator it(lower, j); it; ++it) {
      rows.push_back(static_cast<int>(it.row()));
      columns.push_back(static_cast<int>(it.col()));
      values.push_back(it.value());
    }
  }
  return py::make_tuple(py::array(py::cast(rows)), py::array(py::cast(columns)),
                        py::array(py::cast(values)));
}

std::shared_ptr<const Energy> AnyEnergy(const py::object& energy, Run* run) {
  if (py::isinstance<LibraryEnergy>(energy)) return energy.cast<const LibraryEnergy&>().energy;
  return EnergyOf(energy, run);
}

py::dict Minimize(const py::object& energy, Eigen::VectorXd x, const std::string& strategy,
                  const OptionMap& options, const py::object& progress) {
  const auto run = Run::Make(progress, energy);
  const std::shared_ptr<const Energy> minimised = AnyEnergy(energy, run.get());
  CheckSize(*minimised, x);
  const auto made = ValueOf(MakeSolverStrategy(strategy, options));
  const auto at = std::make_shared<Eigen::VectorXd>(std::move(x));
  const SolveSummary summary = Run::Do(run, [=](const SolveControl& control) {
    return made->Minimize(*minimised, control, at.get());
  });
  py::dict result;
  result["x"] = *at;
  result["value"] = summary.final_value;
  result["gradient_max"] = summary.final_gradient_max;
  result["iterations"] = summary.num_iterations();
  result["converged"] = summary.Converged();
  result["termination"] = ToString(summary.termination);
  result["message"] = summary.message;
  result["strategy"] = summary.strategy;
  return result;
}

py::list Audit(const py::object& energy, const std::vector<Eigen::VectorXd>& inside,
               const std::vector<Eigen::VectorXd>& outside, double step) {
  const auto run = Run::Make(py::none(), energy);
  AuditCase of = {"energy", AnyEnergy(energy, run.get()), {}, {}};
  for (const auto& [points, list] :
       {std::pair(&inside, &of.inside), std::pair(&outside, &of.outside)}) {
    for (const Eigen::VectorXd& x : *points) {
      CheckSize(*of.energy, x);
      list->push_back({"point " + std::to_string(list->size()), x, step});
    }
  }
  const std::vector<AuditFinding> findings =
      Run::Do(run, [of](const SolveControl&) { return AuditEnergy({of}); });
  py::list result;
  for (const AuditFinding& finding : findings) {
    py::dict row;
    row["check"] = finding.check;
    row["ok"] = finding.ok();
    row["applies"] = finding.applies;
    row["figure"] = finding.figure;
    row["bound"] = finding.bound;
    row["where"] = finding.where;
    result.append(row);
  }
  return result;
}

}  // namespace

void BindEnergies(py::module_* module) {
  py::class_<LibraryEnergy>(*module, "LibraryEnergy")
      .def_property_readonly("num_parameters",
                             [](const LibraryEnergy& e) { return e.energy->NumParameters(); })
      .def_property_readonly("is_convex",
                             [](const LibraryEnergy& e) { return e.energy->IsConvex(); })
      .def_property_readonly("gauge_parameters",
                             [](const LibraryEnergy& e) { return e.energy->GaugeParameters(); })
      .def("evaluate", Evaluate)
      .def("hessian", Hessian);
  module->def("energy", MakeLibraryEnergy, py::arg("name"), py::arg("mesh"),
              py::arg("angles") = std::nullopt);
  module->def("energy_names", [] { return Energies().Names(); });
  module->def("strategy_names", [] { return SolverStrategies().Names(); });
  module->def("minimize", Minimize);
  module->def("audit", Audit);
}

}  // namespace cirque::python

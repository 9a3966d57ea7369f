#include "own.h"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "cirque/cones/cone_problem.h"
#include "cirque/energy/array_objective.h"

namespace cirque::python {
namespace {

/// A problem as long as its heuristic runs.
struct ProblemView {
  const ConeProblem* problem;

  const ConeProblem& get() const {
    if (!problem) throw py::value_error("a problem of cones lives as long as its heuristic runs");
    return *problem;
  }
};

class PythonHeuristic final : public ConeHeuristic {
 public:
  PythonHeuristic(py::object choose, Run* run) : choose_(std::move(choose)), run_(run) {}

  StatusOr<std::vector<Cone>> Choose(const ConeProblem& problem) const override {
    std::vector<Cone> cones;
    const bool ok = run_->Call([&] {
      const auto view = std::make_shared<ProblemView>(ProblemView{&problem});
      const auto forget = [](ProblemView* of) { of->problem = nullptr; };
      const std::unique_ptr<ProblemView, decltype(forget)> guard(view.get(), forget);
      for (const py::handle item : choose_(view)) cones.push_back(ConeOf(item));
    });
    if (!ok) return Status(StatusCode::kCancelled, "the cone heuristic raised an exception");
    return cones;
  }

 private:
  static Cone ConeOf(py::handle item) {
    const auto parts = py::tuple(py::reinterpret_borrow<py::object>(item));
    if (parts.size() < 2 || parts.size() > 3) {
      throw py::value_error("a cone is (vertex, angle) or (vertex, least, greatest)");
    }
    return {parts[0].cast<Index>(), parts[1].cast<double>(),
            parts[parts.size() - 1].cast<double>()};
  }

  py::object choose_;
  Run* run_;
};

class PythonObjective final : public ArrayObjective {
 public:
  PythonObjective(py::object distance, Run* run) : distance_(std::move(distance)), run_(run) {}

  void Distances(std::span<const double> references, std::span<const double> x,
                 std::span<ScalarJet> jets) const override {
    std::fill(jets.begin(), jets.end(), ScalarJet{kUnset, kUnset, kUnset});
    run_->Call([&] {
      const auto parts = distance_(ArrayOf(references), ArrayOf(x)).cast<std::array<Doubles, 3>>();
      for (const Doubles& part : parts) {
        if (part.size() == static_cast<py::ssize_t>(jets.size())) continue;
        throw py::value_error("an objective's value, slope and curvature are one a corner");
      }
      for (std::size_t i = 0; i < jets.size(); ++i) {
        jets[i] = {parts[0].data()[i], parts[1].data()[i], parts[2].data()[i]};
      }
    });
  }

 private:
  using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

  static Doubles ArrayOf(std::span<const double> of) {
    return Doubles(static_cast<py::ssize_t>(of.size()), of.data());
  }

  py::object distance_;
  Run* run_;
};

class PythonEnergy final : public Energy {
 public:
  PythonEnergy(py::object energy, Run* run)
      : energy_(std::move(energy)),
        run_(run),
        num_parameters_(energy_.attr("num_parameters").cast<int>()),
        is_convex_(py::getattr(energy_, "is_convex", py::bool_(true)).cast<bool>()),
        gauge_(py::getattr(energy_, "gauge_parameters", py::list()).cast<std::vector<int>>()) {}

  int NumParameters() const override { return num_parameters_; }
  bool IsConvex() const override { return is_convex_; }
  std::vector<int> GaugeParameters() const override { return gauge_; }

  bool Evaluate(const double* x, double* value, double* gradient) const override {
    return AllFinite(x) && Inside([&] {
             const py::object answer =
                 energy_.attr("evaluate")(Eigen::VectorXd::Map(x, num_parameters_));
             if (answer.is_none()) return false;
             const auto [v, g] = answer.cast<std::pair<double, Eigen::VectorXd>>();
             if (g.size() != num_parameters_) {
               throw py::value_error("evaluate: the gradient has " + std::to_string(g.size()) +
                                     " entries; num_parameters is " +
                                     std::to_string(num_parameters_));
             }
             *value = v;
             if (gradient) Eigen::VectorXd::Map(gradient, num_parameters_) = g;
             return true;
           });
  }

  bool Hessian(const double* x, SparseMatrix* lower) const override {
    return AllFinite(x) && Inside([&] {
             const py::object answer =
                 energy_.attr("hessian")(Eigen::VectorXd::Map(x, num_parameters_));
             if (answer.is_none()) return false;
             const auto [rows, columns, values] =
                 answer.cast<std::tuple<Eigen::VectorXi, Eigen::VectorXi, Eigen::VectorXd>>();
             *lower = LowerOf(rows, columns, values);
             return true;
           });
  }

 private:
  SparseMatrix LowerOf(const Eigen::VectorXi& rows, const Eigen::VectorXi& columns,
                       const Eigen::VectorXd& values) const {
    if (rows.size() != columns.size() || rows.size() != values.size()) {
      throw py::value_error("hessian: rows, columns and values differ in length");
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < rows.size(); ++i) {
      if (std::min(rows[i], columns[i]) < 0 || std::max(rows[i], columns[i]) >= num_parameters_) {
        throw py::index_error("hessian: an entry lies outside the matrix");
      }
      if (rows[i] >= columns[i]) entries.emplace_back(rows[i], columns[i], values[i]);
    }
    SparseMatrix lower(num_parameters_, num_parameters_);
    lower.setFromTriplets(entries.begin(), entries.end());
    return lower;
  }

  bool Inside(const std::function<bool()>& ask) const {
    bool inside = false;
    return run_->Call([&] { inside = ask(); }) && inside;
  }

  py::object energy_;
  Run* run_;
  int num_parameters_;
  bool is_convex_;
  std::vector<int> gauge_;
};

/// Lets go of Python objects with the GIL, in whatever thread the last owner is.
template <class Base, class Own>
std::shared_ptr<const Base> Shared(py::object object, Run* run) {
  return std::shared_ptr<const Base>(new Own(std::move(object), run), [](const Base* own) {
    const py::gil_scoped_acquire gil;
    delete own;
  });
}

void BindProblem(py::module_* module) {
  using V = ProblemView;
  const auto of = [](auto member) {
    return [member](const V& view) { return (view.get().*member)(); };
  };
  py::class_<V, std::shared_ptr<V>>(*module, "ConeProblem")
      .def_property_readonly("is_closed", of(&ConeProblem::IsClosed))
      .def_property_readonly("total_curvature", of(&ConeProblem::TotalCurvature))
      .def_property_readonly("greatest_curvature", of(&ConeProblem::GreatestCurvature))
      .def_property_readonly("candidates",
                             [](const V& v) {
                               const std::vector<Index>& all = v.get().candidates();
                               return Eigen::VectorXi(Eigen::VectorXi::Map(all.data(), all.size()));
                             })
      .def_property_readonly("curvature",
                             [](const V& v) { return Eigen::VectorXd(v.get().curvature()); })
      .def_property_readonly("area", [](const V& v) { return Eigen::VectorXd(v.get().area()); })
      .def("least_curvature",
           [](const V& v, Index vertex) {
             if (vertex < 0 || vertex >= v.get().triangulation().num_vertices)
               throw py::index_error();
             return v.get().LeastCurvature(vertex);
           })
      .def("solve",
           [](const V& v, const Eigen::VectorXd& b) {
             if (b.size() != v.get().triangulation().num_vertices) {
               throw py::value_error("solve: one value a vertex is needed");
             }
             return v.get().Solve(b);
           })
      .def("log_scale_without_cones", of(&ConeProblem::LogScaleWithoutCones));
}

}  // namespace

std::shared_ptr<const ConeHeuristic> HeuristicOf(py::object choose, Run* run) {
  return Shared<ConeHeuristic, PythonHeuristic>(std::move(choose), run);
}

std::shared_ptr<const AngleObjective> ObjectiveOf(py::object distance, Run* run) {
  return Shared<AngleObjective, PythonObjective>(std::move(distance), run);
}

std::shared_ptr<const Energy> EnergyOf(py::object energy, Run* run) {
  return Shared<Energy, PythonEnergy>(std::move(energy), run);
}

void BindOwn(py::module_* module) { BindProblem(module); }

}  // namespace cirque::python

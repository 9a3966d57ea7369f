// The compiled half of the package: arrays checked and shaped by Python (cirque/*.py) come here.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glog/logging.h>

#include "cirque/core/parallel.h"
#include "cirque/core/version.h"
#include "cirque/domains/map_arrays.h"
#include "cirque/domains/transfer.h"
#include "cirque/metrics/measure_map.h"
#include "cirque/verify/judge_map.h"

#include "energies.h"
#include "own.h"
#include "run.h"

namespace cirque::python {
namespace {

/// Arrays that Python has made so: in rows, of these types.
using Doubles = py::array_t<double, py::array::c_style>;
using Indices = py::array_t<Index, py::array::c_style>;
using Shape = std::vector<py::ssize_t>;

template <class T>
std::span<const T> SpanOf(const py::array_t<T, py::array::c_style>& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

/// A read-only view of what `owner` keeps.
template <class T>
py::array ViewOf(const T* data, const Shape& shape, py::handle owner) {
  py::array_t<T> view(shape, data, owner);
  py::detail::array_proxy(view.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return view;
}

template <class T>
py::array ViewOf(const std::vector<T>& of, py::handle owner) {
  return ViewOf(of.data(), {static_cast<py::ssize_t>(of.size())}, owner);
}

py::array RowsOf(const std::vector<Eigen::Vector3d>& of, py::handle owner) {
  return ViewOf(reinterpret_cast<const double*>(of.data()),
                {static_cast<py::ssize_t>(of.size()), 3}, owner);
}

py::array RowsOf(const std::vector<Eigen::Vector2d>& of, py::handle owner) {
  return ViewOf(reinterpret_cast<const double*>(of.data()),
                {static_cast<py::ssize_t>(of.size()), 2}, owner);
}

MeshArrays ArraysOf(const Doubles& points, const Indices& corners, const Indices& first) {
  return {SpanOf(points), SpanOf(corners), SpanOf(first)};
}

std::shared_ptr<PreparedMesh> Prepare(const Doubles& points, const Indices& corners,
                                      const Indices& first, const std::string& repair) {
  const MeshArrays arrays = ArraysOf(points, corners, first);
  const auto run = Run::Make(py::none(), py::make_tuple(points, corners, first));
  return Run::Do(run, [arrays, repair](const SolveControl&) {
    MapFailure failure;
    StatusOr<PreparedMesh> made = PreparedMesh::Make(arrays, &failure, repair);
    return std::make_shared<PreparedMesh>(ValueOf(std::move(made), std::move(failure)));
  });
}

std::vector<std::pair<Index, Index>> PairsOf(const Indices& array) {
  std::vector<std::pair<Index, Index>> pairs;
  for (py::ssize_t i = 0; i + 1 < array.size(); i += 2) {
    pairs.emplace_back(array.data()[i], array.data()[i + 1]);
  }
  return pairs;
}

/// What does not go by a text.
struct Given {
  std::vector<std::tuple<Index, double, double>> cones;
  Doubles angle_sums;
  Indices cut, cut_paths;
  py::object heuristic, objective, progress;
  int threads;
};

std::shared_ptr<MeshMap> MapPrepared(const std::shared_ptr<PreparedMesh>& mesh,
                                     const OptionMap& texts, const Given& given) {
  MapOptions options;
  Check(options.Set(texts));
  for (const auto& [vertex, lower, upper] : given.cones) {
    options.cones.push_back({vertex, lower, upper});
  }
  options.angle_sums.assign(given.angle_sums.data(),
                            given.angle_sums.data() + given.angle_sums.size());
  options.cut = PairsOf(given.cut);
  options.cut_paths = PairsOf(given.cut_paths);
  const auto run = Run::Make(given.progress);
  ParameterizeOptions& own = options.options;
  if (!given.heuristic.is_none()) own.own_cones = HeuristicOf(given.heuristic, run.get());
  if (!given.objective.is_none()) own.own_objective = ObjectiveOf(given.objective, run.get());
  return Run::Do(run, [mesh, options, threads = given.threads](const SolveControl& control) {
    const ThreadLimit limit(threads);
    MapFailure failure;
    StatusOr<MeshMap> made = mesh->Map(options, control, &failure);
    return std::make_shared<MeshMap>(ValueOf(std::move(made), std::move(failure)));
  });
}

py::tuple TupleOf(const MapVerdict& verdict) {
  return py::make_tuple(verdict.valid, verdict.verdict, verdict.errors, verdict.json);
}

py::tuple Judge(const std::shared_ptr<PolygonSoup>& mesh, const Doubles& uv, const Indices& f_uv,
                const OptionMap& texts) {
  JudgeOptions options;
  Check(JudgeOptionTable().Set(texts, &options));
  PolygonSoup mapped = *mesh;
  mapped.texture.resize(uv.size() / 2);
  for (std::size_t i = 0; i < mapped.texture.size(); ++i) {
    mapped.texture[i] = Eigen::Vector2d::Map(uv.data() + 2 * i);
  }
  mapped.corner_texture.assign(f_uv.data(), f_uv.data() + f_uv.size());
  return TupleOf(Run::Do(Run::Make(py::none()), [mesh, mapped, options](const SolveControl&) {
    return ValueOf(JudgeMap(*mesh, mapped, options));
  }));
}

py::tuple JudgeOnSphere(const PolygonSoup& mesh, const Doubles& position, const OptionMap& texts) {
  JudgeOptions options;
  Check(JudgeOptionTable().Set(texts, &options));
  std::vector<Eigen::Vector3d> points(position.size() / 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = Eigen::Vector3d::Map(position.data() + 3 * i);
  }
  return TupleOf(ValueOf(JudgeSphereMap(mesh, points, options)));
}

/// The points of a map at the corners of the mesh's surface.
CornerUv CornersOf(const PreparedMesh& mesh, const Doubles& uv, const Indices& f_uv) {
  if (f_uv.size() != static_cast<py::ssize_t>(mesh.soup().corner.size())) {
    throw py::value_error("f_uv: a row for every corner is needed");
  }
  const std::shared_ptr<const Surface> surface = mesh.surface();
  CornerUv of_corner;
  of_corner.value.reserve(surface->soup_corner.size());
  for (const Index c : surface->soup_corner) {
    const Index row = f_uv.data()[c];
    of_corner.value.emplace_back(uv.data()[2 * row], uv.data()[2 * row + 1]);
  }
  return of_corner;
}

/// A texture of the unit square, rows from below (height x width x channels), moved from one map to
/// another.
Doubles Transfer(const PreparedMesh& mesh, const CornerUv& from, const CornerUv& to,
                 const Doubles& image, Index width, Index height, int margin) {
  const auto unit = Eigen::AlignedBox2d(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1));
  const std::span<const double> values = SpanOf(image);
  const Texture texture{static_cast<int>(image.shape(1)),
                        static_cast<int>(image.shape(0)),
                        static_cast<int>(image.shape(2)),
                        unit,
                        {values.begin(), values.end()}};
  const std::shared_ptr<const Surface> surface = mesh.surface();
  const Texture moved = Run::Do(Run::Make(py::none()), [=](const SolveControl&) {
    Texture image_of_to{width, height, texture.channels, unit, {}};
    const Triangulation& t = surface->triangulation;
    TransferTexture(MapLocator(TrianglesOf(t, from)), texture, MapLocator(TrianglesOf(t, to)),
                    margin, &image_of_to);
    return image_of_to;
  });
  return Doubles({height, width, texture.channels}, moved.value.data());
}

/// Figures by name; with `faces` also per measure a value for each triangle of its surfaces.
py::tuple Measure(const PreparedMesh& mesh, const Doubles& uv, const Indices& f_uv, bool faces) {
  const std::shared_ptr<const Surface> surface = mesh.surface();
  const CornerUv of_corner = CornersOf(mesh, uv, f_uv);
  const MapMeasures measures =
      Run::Do(Run::Make(py::none()), [surface, of_corner](const SolveControl&) {
        return MeasureMap(surface->triangulation, MeasureEdgeLengths(*surface), of_corner);
      });
  py::dict figures, values;
  for (const auto& figure : measures.figures) figures[py::str(figure.name)] = figure.value;
  for (const auto& face : measures.faces) {
    if (!faces) break;
    values[py::str(face.measure)] =
        py::array_t<double>(static_cast<py::ssize_t>(face.value.size()), face.value.data());
  }
  return py::make_tuple(figures, values);
}

py::list Infos(const std::vector<OptionInfo>& infos) {
  py::list rows;
  for (const OptionInfo& info : infos) {
    py::dict row;
    row["name"] = info.name;
    row["kind"] = static_cast<int>(info.kind);
    row["help"] = info.help;
    row["default"] = info.default_text;
    row["words"] = info.words;
    row["unit"] = info.unit;
    row["group"] = info.group;
    row["expectation"] = Expectation(info);
    row["former"] = info.former;
    rows.append(row);
  }
  return rows;
}

py::dict DomainsByName() {
  py::dict domains;
  for (const std::string& name : Domains().Names()) {
    const Domain domain = *Domains().Find(name);
    domains[py::str(name)] = py::make_tuple(domain.help, domain.reads);
  }
  return domains;
}

void BindMeshes(py::module_* module) {
  py::class_<PreparedMesh, std::shared_ptr<PreparedMesh>>(*module, "PreparedMesh")
      .def_property_readonly("components", &PreparedMesh::num_components)
      .def_property_readonly(
          "report", [](const PreparedMesh& m) { return m.report().Text() + m.repair().Text(); });
  py::class_<PolygonSoup, std::shared_ptr<PolygonSoup>>(*module, "Polygons")
      .def(py::init([](const Doubles& points, const Indices& corners, const Indices& first) {
        return ValueOf(SoupOf(ArraysOf(points, corners, first)));
      }));
  py::class_<Given>(*module, "Given")
      .def(py::init<>())
      .def_readwrite("cones", &Given::cones)
      .def_readwrite("angle_sums", &Given::angle_sums)
      .def_readwrite("cut", &Given::cut)
      .def_readwrite("cut_paths", &Given::cut_paths)
      .def_readwrite("heuristic", &Given::heuristic)
      .def_readwrite("objective", &Given::objective)
      .def_readwrite("progress", &Given::progress)
      .def_readwrite("threads", &Given::threads);
  const auto view = [](auto member) {
    return [member](py::object self) { return member(self.cast<const MeshMap&>(), self); };
  };
  py::class_<CornerUv>(*module, "CornerUv");
  py::class_<MeshMap, std::shared_ptr<MeshMap>>(*module, "MeshMap")
      .def_property_readonly(
          "uv", view([](const MeshMap& m, py::handle o) { return RowsOf(m.mesh.texture, o); }))
      .def_property_readonly("f_uv", view([](const MeshMap& m, py::handle o) {
                               return ViewOf(m.mesh.corner_texture, o);
                             }))
      .def_property_readonly(
          "corners", view([](const MeshMap& m, py::handle o) { return ViewOf(m.mesh.corner, o); }))
      .def_property_readonly("first_corner", view([](const MeshMap& m, py::handle o) {
                               return ViewOf(m.mesh.first_corner, o);
                             }))
      .def_property_readonly(
          "position", view([](const MeshMap& m, py::handle o) { return RowsOf(m.position, o); }))
      .def_property_readonly("has_exact", [](const MeshMap& m) { return m.exact.has_value(); })
      .def_property_readonly("exact_vertices", view([](const MeshMap& m, py::handle o) {
                               return RowsOf(m.exact->mesh.position, o);
                             }))
      .def_property_readonly("exact_faces", view([](const MeshMap& m, py::handle o) {
                               return ViewOf(m.exact->mesh.corner, o);
                             }))
      .def_property_readonly("exact_uv", view([](const MeshMap& m, py::handle o) {
                               return RowsOf(m.exact->mesh.texture, o);
                             }))
      .def_property_readonly("exact_f_uv", view([](const MeshMap& m, py::handle o) {
                               return ViewOf(m.exact->mesh.corner_texture, o);
                             }))
      .def_property_readonly("exact_face_of_input", view([](const MeshMap& m, py::handle o) {
                               return ViewOf(m.exact->polygon, o);
                             }))
      .def_property_readonly("exact_position", view([](const MeshMap& m, py::handle o) {
                               return RowsOf(m.exact->sphere, o);
                             }))
      .def_property_readonly("exact_weight", view([](const MeshMap& m, py::handle o) {
                               return ViewOf(m.exact->weight, o);
                             }))
      .def_property_readonly("outcome", [](const MeshMap& m) { return m.certificate.outcome; })
      .def_property_readonly("certificate",
                             [](const MeshMap& m) { return m.certificate.ToJson(); });
}

}  // namespace

PYBIND11_MODULE(_cirque, module) {
  FLAGS_logtostderr = true;
  FLAGS_minloglevel = google::GLOG_ERROR;  // Ceres warns of what the summaries say
  TranslateStatusErrors();
  BindMeshes(&module);
  BindOwn(&module);
  BindEnergies(&module);
  module.def("prepare", Prepare);
  module.def("map", MapPrepared);
  module.def("judge", Judge);
  module.def("judge_sphere", JudgeOnSphere);
  module.def("measure", Measure);
  module.def("corners_of", CornersOf);
  module.def("transfer", Transfer);
  module.def("option_infos", [] { return Infos(MapOptionInfos()); });
  module.def("judge_infos", [] { return Infos(JudgeOptionTable().Infos()); });
  module.def("domains", DomainsByName);
  module.def("version", [] { return Version(); });
}

}  // namespace cirque::python

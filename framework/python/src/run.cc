#include "run.h"

#include <pybind11/stl.h>

#include <chrono>
#include <utility>
#include <vector>

#include "cirque/linear/blas_threads.h"

namespace cirque::python {
namespace {

constexpr std::chrono::milliseconds kBetweenSignals(50), kPatience(500);

/// The vertices that a failure is about, from 0.
std::vector<Index> VerticesOf(const MapFailure& failure) {
  const PreflightReport& report = failure.preflight;
  std::vector<Index> vertices = failure.certificate.infeasibility.carrying_vertices;
  for (const auto* list : {&report.non_finite_vertices, &report.non_manifold_vertices}) {
    vertices.insert(vertices.end(), list->begin(), list->end());
  }
  for (const auto& [a, b] : report.non_manifold_edges) vertices.insert(vertices.end(), {a, b});
  return vertices;
}

std::vector<Index> FacesOf(const MapFailure& failure) {
  std::vector<Index> faces = failure.certificate.infeasibility.carrying_faces;
  for (const auto* list :
       {&failure.preflight.repeated_vertex_faces, &failure.preflight.zero_area_faces}) {
    faces.insert(faces.end(), list->begin(), list->end());
  }
  return faces;
}

void Raise(const StatusError& error) {
  const std::string certificate =
      error.failure.certificate.outcome == "not_run" ? "" : error.failure.certificate.ToJson();
  const py::object raised =
      py::module_::import("cirque._errors")
          .attr("error_of")(ToString(error.status.code()), error.status.message(), certificate,
                            VerticesOf(error.failure), FacesOf(error.failure),
                            std::const_pointer_cast<MeshMap>(error.failure.partial));
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(raised.ptr())), raised.ptr());
}

}  // namespace

void TranslateStatusErrors() {
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const StatusError& status) {
      Raise(status);
    }
  });
}

std::shared_ptr<Run> Run::Make(py::object progress, py::object kept) {
  return {new Run(std::move(progress), std::move(kept)), [](const Run* run) {
            const py::gil_scoped_acquire gil;
            delete run;
          }};
}

void Run::Keep(py::error_already_set&& error) {
  cancelled_ = is_deaf_ = true;
  if (!raised_) raised_.emplace(std::move(error));
}

bool Run::Call(const std::function<void()>& function) {
  if (is_deaf_) return false;
  const py::gil_scoped_acquire gil;
  if (is_deaf_) return false;
  try {
    function();
    return true;
  } catch (py::error_already_set& error) {
    Keep(std::move(error));
  } catch (const py::cast_error& error) {
    PyErr_SetString(PyExc_TypeError, error.what());
    Keep(py::error_already_set());
  } catch (const py::builtin_exception& error) {
    error.set_error();
    Keep(py::error_already_set());
  }
  return false;
}

SolveControl Run::Control() {
  SolveControl control;
  control.cancelled = &cancelled_;
  control.on_stage = [this](std::string_view stage) { stage_ = stage; };
  if (progress_.is_none()) return control;
  control.callback = [this](const IterationRecord& record, const Eigen::VectorXd&) {
    bool go_on = true;
    const bool called = Call([&] {
      const py::object answer =
          progress_(stage_, record.iteration, record.gradient_max, record.seconds);
      go_on = !answer.is(py::bool_(false));
    });
    if (!go_on) cancelled_ = true;
    return called && go_on ? CallbackAction::kContinue : CallbackAction::kStop;
  };
  return control;
}

void Run::DoInThread(const Work& work) {
  const OneBlasThread blas;
  std::exception_ptr thrown;
  try {
    work(Control());
  } catch (...) {
    thrown = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  thrown_ = thrown;
  has_ended_ = true;
  ended_.notify_one();
}

void Run::CheckSignals() {
  const py::gil_scoped_acquire gil;
  if (PyErr_CheckSignals() != 0) Keep(py::error_already_set());
}

/// False where it is no longer waited for.
bool Run::WaitForEnd() {
  const auto ended = [this] { return has_ended_; };
  std::unique_lock lock(mutex_);
  for (std::chrono::milliseconds patience = kPatience; patience.count() > 0;) {
    if (ended_.wait_for(lock, kBetweenSignals, ended)) return true;
    if (is_deaf_) patience -= kBetweenSignals;
    lock.unlock();
    CheckSignals();
    lock.lock();
  }
  return has_ended_;
}

void Run::LeaveBehind(const std::shared_ptr<Run>& run) {
  py::module_::import("atexit").attr("register")(py::cpp_function([run] {
    const py::gil_scoped_release release;
    run->thread_.join();
  }));
}

void Run::DoUnheard(const std::shared_ptr<Run>& run, Work work) {
  run->thread_ = std::thread([run, work = std::move(work)] { run->DoInThread(work); });
  bool has_ended = false;
  {
    const py::gil_scoped_release release;
    has_ended = run->WaitForEnd();
    if (has_ended) run->thread_.join();
  }
  if (!has_ended) LeaveBehind(run);
  if (run->raised_) throw py::error_already_set(*std::exchange(run->raised_, std::nullopt));
  if (run->thrown_) std::rethrow_exception(run->thrown_);
}

}  // namespace cirque::python

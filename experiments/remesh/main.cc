// A surface meshed anew, by a conformal map of it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cirque/core/atomic_file.h"
#include "cirque/domains/atlas.h"
#include "cirque/domains/domain.h"
#include "cirque/domains/map_mesh.h"
#include "cirque/io/file_input.h"
#include "cirque/io/io.h"
#include "cirque/remesh/curvature_density.h"
#include "cirque/remesh/mesh_quality.h"
#include "cirque/remesh/remesh_surface.h"

#include "experiments/common/process.h"
#include "experiments/common/program.h"
#include "experiments/common/solve_progress.h"
#include "experiments/remesh/settings.h"

namespace cirque {
namespace {

/// Numbers of a file, one a line and vertex.
StatusOr<Eigen::VectorXd> ReadDensity(const std::string& path, std::size_t vertices) {
  const StatusOr<std::string> content = ReadFileContent(path);
  if (!content.ok()) return content.status();
  TextScanner text(path, *content);
  std::vector<double> values;
  while (text.NextLine()) {
    const std::optional<double> number = text.Number();
    if (!number || !(*number > 0) || !text.AtLineEnd()) return text.Expected("a positive number");
    values.push_back(*number);
  }
  if (values.size() != vertices) {
    return Status::InvalidInput(
        fmt::format("{}: {} numbers; the mesh has {} vertices", path, values.size(), vertices));
  }
  return Eigen::VectorXd(
      Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size())));
}

/// A run of the program.
class Run {
 public:
  Run(const RemeshSettings& settings, std::string in, std::string out, const SolveControl& control,
      std::ostream& report)
      : settings_(settings),
        in_(std::move(in)),
        out_(std::move(out)),
        control_(control),
        report_(report) {}

  Status Remesh() {
    if (Status s = CheckPaths(); !s.ok()) return s;
    if (Status s = Read(); !s.ok()) return s;
    for (const Surface* surface : parts_.Surfaces()) {
      if (Status s = Add(*surface); !s.ok()) return s.In(in_);
    }
    control_.BeginStage("writing");
    if (Status s = WriteMesh(out_, made_); !s.ok()) return s;
    if (!settings_.correspondence.empty()) {
      if (Status s = WriteFileAtomically(settings_.correspondence, correspondence_); !s.ok())
        return s;
    }
    return Measure("safe");
  }

  Status MeasureOnly() {
    if (Status s = Read(); !s.ok()) return s;
    StatusOr<PolygonSoup> made = ReadMesh(out_);
    if (!made.ok()) return made.status();
    made_ = *std::move(made);
    return Measure("none");
  }

 private:
  Status CheckPaths() const {
    for (const std::string& path : {out_, settings_.correspondence, settings_.report}) {
      if (path.empty()) continue;
      if (path == in_)
        return Status::InvalidInput(path + ": an output would replace the input; name another");
      if (Status s = CheckOutputPath(path); !s.ok()) return s;
    }
    return Status();
  }

  Status Read() {
    control_.BeginStage("reading");
    StatusOr<PolygonSoup> soup = ReadMesh(in_);
    if (!soup.ok()) return soup.status();
    soup_ = *std::move(soup);
    for (const std::string& warning : soup_.warnings) report_ << "warning: " << warning << "\n";
    if (Status s = TakeApart(soup_, settings_.repair, &parts_); !s.ok()) return s.In(in_);
    for (const MeshComponent& component : parts_.components) {
      if (!component.surface.ok()) return component.surface.status().In(in_);
    }
    if (settings_.density.empty()) return Status();
    if (NamesCurvatureSizing(settings_.density)) {
      const StatusOr<CurvatureSizing> sizing = ParseCurvatureSizing(settings_.density);
      if (!sizing.ok()) return sizing.status().In("--density");
      sizing_ = *sizing;
      return Status();
    }
    StatusOr<Eigen::VectorXd> density = ReadDensity(settings_.density, soup_.position.size());
    if (density.ok()) density_ = *std::move(density);
    return density.status();
  }

  /// Of several components each gets its share of the vertices, by its area.
  StatusOr<RemeshOptions> OptionsFor(const Surface& surface) const {
    RemeshOptions options = settings_.mesh;
    if (sizing_) options.density = DensityByCurvature(surface, *sizing_);
    if (density_.size() > 0) {
      options.density.resize(surface.triangulation.num_vertices);
      for (Index v = 0; v < surface.triangulation.num_vertices; ++v)
        options.density[v] = density_[surface.soup_vertex[v]];
    }
    if (options.vertices > 0 && !parts_.IsOne()) {
      double all = 0;
      for (const Surface* other : parts_.Surfaces()) all += AreaOf(*other);
      const double share = AreaOf(surface) / all;
      options.vertices = std::max(4, static_cast<int>(std::lround(share * options.vertices)));
    }
    return options;
  }

  static double AreaOf(const Surface& surface) {
    double area = 0;
    const Index* v = surface.triangulation.vertex.data();
    for (Index f = 0; f < surface.triangulation.num_faces(); ++f, v += 3) {
      const Eigen::Vector3d& a = surface.position[v[0]];
      area += 0.5 * (surface.position[v[1]] - a).cross(surface.position[v[2]] - a).norm();
    }
    return area;
  }

  Status Add(const Surface& surface) {
    MapRequest request;
    request.options = settings_.map;
    request.options.exact = true;
    request.options.refine_map = "none";
    if (request.options.holonomy == HolonomyRule::kFree) {
      if (settings_.mesh.lattice == MeshLattice::kSquares)
        request.options.holonomy = HolonomyRule::kHalves;
      if (settings_.mesh.lattice == MeshLattice::kTriangles)
        request.options.holonomy = HolonomyRule::kThirds;
    }
    const StatusOr<SurfaceMap> map = MapSurface(surface, request, control_);
    if (!map.ok()) return map.status();
    const StatusOr<RemeshOptions> options = OptionsFor(surface);
    const StatusOr<RemeshedSurface> made = RemeshSurface(surface, *map, *options, control_);
    if (!made.ok()) return made.status();
    const auto first = static_cast<Index>(made_.position.size());
    for (std::size_t v = 0; v < made->point.size(); ++v) {
      made_.position.push_back(made->position[v]);
      AddCorrespondence(surface, made->point[v]);
    }
    AddFaces(*made, first);
    report_ << fmt::format("edges       {:.6g}\ncones       {}\n", made->edge, made->cones.size());
    return Status();
  }

  void AddFaces(const RemeshedSurface& made, Index first) {
    const bool squares = !made.squares.empty();
    const auto add = [this, first](const auto* corners, Index count) {
      for (Index k = 0; k < count; ++k) made_.corner.push_back(first + corners[k]);
      made_.first_corner.push_back(made_.first_corner.back() + count);
    };
    for (const auto& square : made.squares) add(square.data(), 4);
    if (squares) return;
    for (Index f = 0; f < made.triangulation.num_faces(); ++f)
      add(&made.triangulation.vertex[3 * f], 3);
  }

  void AddCorrespondence(const Surface& surface, const SurfacePoint& point) {
    correspondence_ += fmt::format("{}", surface.soup_polygon[point.face] + 1);
    for (Index c = 3 * point.face; c < 3 * point.face + 3; ++c)
      correspondence_ +=
          fmt::format(" {}", surface.soup_vertex[surface.triangulation.vertex[c]] + 1);
    for (Eigen::Index k = 0; k < 3; ++k)
      correspondence_ += fmt::format(" {}", point.barycentric[k]);
    correspondence_ += "\n";
  }

  Status Measure(const std::string& repair) {
    control_.BeginStage("measuring");
    MeshParts made;
    if (Status s = TakeApart(made_, repair, &made); !s.ok()) return s.In(out_);
    if (made.Surfaces().empty()) return made.components[0].surface.status().In(out_);
    const Surface whole = Joined(made.Surfaces());
    MeshQuality quality = MeasureQuality(whole.triangulation, whole.position);
    MeasureDistances(whole.triangulation, whole.position, Joined(parts_.Surfaces()), &quality);
    report_ << ToText(quality);
    if (settings_.report.empty()) return Status();
    return WriteFileAtomically(settings_.report, ToJson(quality));
  }

  const RemeshSettings& settings_;
  std::string in_, out_;
  const SolveControl& control_;
  std::ostream& report_;
  PolygonSoup soup_, made_;
  MeshParts parts_;
  Eigen::VectorXd density_;
  std::optional<CurvatureSizing> sizing_;
  std::string correspondence_;
};

int Complain(const Status& status) {
  fmt::print(stderr, "remesh: {}\n", status.message());
  return ExitStatus(status.code());
}

int Main(int argc, char** argv) {
  RemeshSettings settings;
  CommandLine line = RemeshFlags(&settings);
  const StatusOr<std::vector<std::string>> given = line.Parse({argv + 1, argv + argc});
  if (!given.ok()) return Complain(given.status());
  if (const auto answered = AnswerQuestions(RemeshManual(), line, *given)) return *answered;
  if (given->size() != 2) {
    return Complain(Status::InvalidInput(
        fmt::format("{} files given; write remesh --edge=LENGTH IN OUT", given->size())));
  }
  if (settings.quads) settings.mesh.lattice = MeshLattice::kSquares;
  if (Status s = CheckSettings(settings); !s.ok()) return Complain(s);
  SolveProgress progress(settings.quiet ? nullptr : stderr);
  std::ostream report(settings.quiet ? nullptr : progress.Before(std::cout));
  CatchInterrupts();
  const SolveControl control = progress.Control(InterruptFlag());
  Run run(settings, (*given)[0], (*given)[1], control, report);
  const Status status = settings.measure ? run.MeasureOnly() : run.Remesh();
  progress.Erase();
  return status.ok() ? 0 : Complain(status);
}

}  // namespace
}  // namespace cirque

int main(int argc, char** argv) { return cirque::RunMain("remesh", argc, argv, cirque::Main); }

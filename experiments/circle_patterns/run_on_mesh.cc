// The program on meshes.
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/solve_summary.h"
#include "cirque/domains/map_mesh.h"
#include "cirque/io/io.h"

#include "experiments/circle_patterns/job.h"
#include "experiments/circle_patterns/outputs.h"
#include "experiments/circle_patterns/request.h"
#include "experiments/common/process.h"

namespace cirque {
namespace {

/// One mesh on its way through the program.
class MeshRun {
 public:
  MeshRun(const CirclePatternsJob& job, const SolveControl& control, std::ostream& report)
      : job_(job), control_(control), report_(report) {}

  Status Run() {
    if (Status s = Read(); !s.ok()) return s;
    if (Status s = Prepare(); !s.ok()) return s.In(job_.input);
    if (Status s = Map(); !s.ok()) return s;
    const bool is_refused = mapped_.status.code() == StatusCode::kInvalidInput;
    if (!mapped_.surface && parts_->IsOne() && is_refused) return mapped_.status.In(job_.input);
    if (mapped_.surface) {
      if (Status s = Write(); !s.ok()) return s;
    }
    const Surface none;
    return WriteCertificate(job_, mapped_.proof_surface ? *mapped_.proof_surface : none, timer_,
                            &mapped_.map.certificate, Outcome(), report_);
  }

 private:
  Status Read() {
    control_.BeginStage("reading");
    StatusOr<MeshFile> file = ReadMeshFile(job_.input);
    if (!file.ok()) return file.status();
    file_ = *std::move(file);
    for (const std::string& warning : file_.soup.warnings) {
      report_ << "warning     " << warning << "\n";
    }
    read_seconds_ = timer_.Seconds();
    return Status();
  }

  /// The components, judged and as repaired as the job lets them be.
  Status Prepare() {
    control_.BeginStage("checking");
    const Status status = TakeApart(file_.soup, job_.mesh.repair, parts_.get());
    report_ << parts_->report.Text() << parts_->repair.Text();
    if (!status.ok() || parts_->IsOne() || job_.con.empty()) return status;
    return Status::InvalidInput(
        fmt::format("-oc holds the metric of one component; the mesh has {}: leave it out, or keep "
                    "one of them in a file",
                    parts_->Sizes()));
  }

  Status Map() {
    const auto num_vertices = static_cast<Index>(file_.soup.position.size());
    Status asked;  // what is wrong with the request names its own file or flag
    const SurfaceRequest request = [&](const Surface& surface) {
      StatusOr<MapRequest> made = RequestOf(job_, num_vertices, surface);
      asked = made.status();
      return made;
    };
    StatusOr<MappedMesh> mapped = MapMesh(parts_, job_.mesh, request, control_);
    if (!mapped.ok()) {
      const bool is_of_mesh = asked.ok() && mapped.status().code() != StatusCode::kCancelled;
      return is_of_mesh ? mapped.status().In(job_.input) : mapped.status();
    }
    mapped_ = *std::move(mapped);
    mapped_.map.certificate.seconds.read = read_seconds_;
    if (job_.mesh.fill_holes) {
      report_ << fmt::format("{} holes filled for the solve\n", mapped_.num_filled_loops);
    }
    return Status();
  }

  /// An inaccurate map is written, and is not well.
  Status Outcome() const {
    const Certificate& all = mapped_.map.certificate;
    if (!mapped_.status.ok() || all.outcome != kInaccurate) return mapped_.status;
    return {StatusCode::kNotConverged, all.message};
  }

  Status Write() {
    Certificate& certificate = mapped_.map.certificate;
    report_ << Summary(certificate);
    if (job_.mesh.uv != MeshOptions().uv) report_ << "frame       " << job_.mesh.uv << "\n";
    control_.BeginStage("writing");
    const Timer timer;
    const Input input = {file_, *mapped_.surface, *mapped_.solved_surface};
    if (Status s = WriteOutputs(job_, input, report_, &mapped_.map); !s.ok()) return s;
    certificate.seconds.write = timer.Seconds();
    report_ << fmt::format("wrote       {} ({:.2f} s, {:.0f} MB)\n", job_.output, timer_.Seconds(),
                           PeakMemoryMib());
    return Status();
  }

  const CirclePatternsJob& job_;
  const SolveControl& control_;
  std::ostream& report_;
  Timer timer_;
  double read_seconds_ = 0;
  MeshFile file_;
  std::shared_ptr<MeshParts> parts_ = std::make_shared<MeshParts>();
  MappedMesh mapped_;
};

}  // namespace

Status RunOnMesh(const CirclePatternsJob& job, const SolveControl& control, std::ostream& report) {
  if (Status s = CheckOutputs(job); !s.ok()) return s;
  return MeshRun(job, control, report).Run();
}

}  // namespace cirque

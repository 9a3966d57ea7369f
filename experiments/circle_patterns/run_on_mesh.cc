// The program on meshes.
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/solve_summary.h"
#include "cirque/io/io.h"
#include "cirque/mesh/holes.h"
#include "cirque/mesh/preflight.h"

#include "experiments/circle_patterns/job.h"
#include "experiments/circle_patterns/outputs.h"
#include "experiments/circle_patterns/request.h"
#include "experiments/common/process.h"

namespace cirque {
namespace {

/// The surface to solve on where holes are to be filled; nothing otherwise.
StatusOr<std::optional<FilledSurface>> FillIfAsked(const CirclePatternsJob& job,
                                                   const Surface& surface, std::ostream& report) {
  if (!job.fill_holes) return std::optional<FilledSurface>();
  StatusOr<FilledSurface> filled = FillHoles(surface, KeptLoops::kLongest);
  if (!filled.ok()) return filled.status().In(job.input);
  report << fmt::format("{} holes filled for the solve\n", filled->num_filled_loops);
  return std::optional<FilledSurface>(*std::move(filled));
}

}  // namespace

Status RunOnMesh(const CirclePatternsJob& job, const SolveControl& control, std::ostream& report) {
  const Timer timer;
  if (Status s = CheckOutputs(job); !s.ok()) return s;
  const StatusOr<PolygonSoup> soup = ReadMesh(job.input);
  if (!soup.ok()) return soup.status();
  const double read_seconds = timer.Seconds();
  PreflightReport preflight;
  const StatusOr<Surface> surface = Preflight(*soup, &preflight);
  report << preflight.Text();
  if (!surface.ok()) return surface.status().In(job.input);
  const double preflight_seconds = timer.Seconds() - read_seconds;

  const auto filled = FillIfAsked(job, *surface, report);
  if (!filled.ok()) return filled.status();
  const Surface& solved = *filled ? (*filled)->surface : *surface;
  const auto request = RequestOf(job, static_cast<Index>(soup->position.size()), solved);
  if (!request.ok()) return request.status();

  Certificate failed;
  StatusOr<SurfaceMap> map = MapSurface(solved, *request, control, &failed);
  const Status& status = map.status();
  if (status.code() == StatusCode::kInvalidInput) return status.In(job.input);
  if (status.code() == StatusCode::kCancelled) return status;
  Certificate& certificate = map.ok() ? map->certificate : failed;
  certificate.seconds.read = read_seconds;
  certificate.seconds.preflight = preflight_seconds;
  if (map.ok()) {
    report << Summary(certificate);
    const Timer write_timer;
    const Input input = {*soup, *surface, *filled ? &**filled : nullptr};
    if (Status s = WriteOutputs(job, input, report, &*map); !s.ok()) return s;
    certificate.seconds.write = write_timer.Seconds();
    report << fmt::format("wrote       {} ({:.2f} s, {:.0f} MB)\n", job.output, timer.Seconds(),
                          PeakMemoryMib());
  }
  const Status written = WriteCertificate(job, solved, timer, &certificate, status, report);
  if (!written.ok() || certificate.outcome != kInaccurate) return written;
  return {StatusCode::kNotConverged, certificate.message};
}

}  // namespace cirque

#include "experiments/circle_patterns/run.h"

#include <sys/resource.h>

#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "cirque/core/atomic_file.h"
#include "cirque/core/timer.h"
#include "cirque/cuts/cut_file.h"
#include "cirque/mesh/con_file.h"
#include "cirque/mesh/cone_file.h"
#include "cirque/mesh/hole_filling.h"
#include "cirque/mesh/io.h"
#include "cirque/mesh/preflight.h"
#include "cirque/pipeline/infeasibility_files.h"

namespace cirque {
namespace {

double ValueOr(const Certificate& certificate, const std::string& name, double fallback) {
  const auto found = certificate.values.find(name);
  return found == certificate.values.end() ? fallback : found->second;
}

/// Of this process so far; Linux counts in kilobytes.
double PeakMemoryInMegabytes() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// The evidence in a few lines for people.
std::string Summary(const Certificate& c) {
  const auto value = [&](const char* name) { return ValueOr(c, name, kUnset); };
  std::string text = fmt::format(
      "angles      {:.0f} steps, smallest corner {:.2e} rad, intersection {:.2e} rad, gap {:.1e}\n",
      value("angle_iterations"), value("smallest_angle"), value("smallest_theta"),
      value("angle_gap"));
  text +=
      fmt::format("radii       {:.0f} steps, gradient {:.1e} rad, gap {:.1e}, log range {:.1f}\n",
                  value("radii_iterations"), value("radii_gradient"), value("radii_gap"),
                  value("log_radius_range"));
  text += fmt::format(
      "map         {:.0f} flipped triangles, {}, quasi-conformal {:.5f} mean {:.4g} max\n",
      value("flipped_triangles"), c.overlap, value("quasi_conformal_mean"),
      value("quasi_conformal_max"));
  if (value("cones") > 0 || value("seams") > 0) {
    text += fmt::format("cut         {:.0f} cones, {:.0f} seams, rotation {:.1e} rad, gap {:.1e}\n",
                        value("cones"), value("seams"), value("seam_rotation_mismatch"),
                        value("seam_gap"));
  }
  return text;
}

/// What the job prescribes, or else the default of the surface.
StatusOr<ConeTargets> TargetsOf(const CirclePatternsJob& job, const PolygonSoup& soup,
                                const Surface& surface) {
  const FileVertices vertices = {static_cast<Index>(soup.position.size()), surface.soup_vertex};
  if (!job.angle_sums.empty()) {
    return ReadAngleSumFile(job.angle_sums, surface.triangulation, vertices);
  }
  if (!job.cones.empty()) return ReadConeFile(job.cones, surface.triangulation, vertices);
  return DefaultTargets(surface);
}

Status WriteFlatMetric(const CirclePatternsJob& job, const FlatSurface& flat) {
  if (job.con.empty()) return Status();
  return WriteCon(job.con, flat.intrinsic.triangulation, flat.intrinsic_lengths);
}

/// The faces and vertices that carry a proof, as a table and as a coloured mesh.
Status WriteCarriers(const std::string& stem, const Surface& surface,
                     const InfeasibilityProof& proof, std::ostream& report) {
  const std::string csv = stem + ".infeasible.csv", ply = stem + ".infeasible.ply";
  if (Status s = WriteFileAtomically(csv, InfeasibilityCsv(proof)); !s.ok()) return s;
  if (Status s = WriteFileAtomically(ply, InfeasibilityPly(surface, proof)); !s.ok()) return s;
  report << "carriers    " << csv << ", " << ply << "\n";
  return Status();
}

}  // namespace

std::string CarrierStem(const CirclePatternsJob& job) {
  const std::string path = CertificatePath(job);
  for (const std::string ending : {".certificate.json", ".json"}) {
    if (path.ends_with(ending)) return path.substr(0, path.size() - ending.size());
  }
  return path;
}

std::string CertificatePath(const CirclePatternsJob& job) {
  if (!job.certificate.empty()) return job.certificate;
  const std::string& output = job.output.empty() ? job.con : job.output;
  return std::filesystem::path(output).replace_extension(".certificate.json").string();
}

Status RunCirclePatterns(const CirclePatternsJob& job, const SolveControl& control,
                         std::ostream& report) {
  const Timer timer;
  if (std::filesystem::path(job.output).extension() != ".obj") {
    return Status::InvalidInput(job.output + ": maps are written as .obj; name the output so");
  }
  const StatusOr<PolygonSoup> soup = ReadMesh(job.input);
  if (!soup.ok()) return soup.status();
  const double read_seconds = timer.Seconds();
  PreflightReport preflight;
  const StatusOr<Surface> surface = Preflight(*soup, &preflight);
  report << preflight.Text();
  if (!surface.ok()) return surface.status().In(job.input);
  const double preflight_seconds = timer.Seconds() - read_seconds;

  FilledSurface filled = {*surface, surface->triangulation.num_faces(),
                          surface->triangulation.num_vertices, 0};
  if (job.fill_holes) {
    StatusOr<FilledSurface> closed = FillHoles(*surface, KeptLoops::kLongest);
    if (!closed.ok()) return closed.status().In(job.input);
    filled = *std::move(closed);
    report << fmt::format("{} holes filled for the solve\n", filled.num_filled_loops);
  }
  const StatusOr<ConeTargets> targets = TargetsOf(job, *soup, filled.surface);
  if (!targets.ok()) return targets.status();
  std::optional<Cut> cut;
  if (!job.cut.empty()) {
    StatusOr<Cut> read =
        ReadCutFile(job.cut, filled.surface.triangulation, NumbersInFile(filled.surface));
    if (!read.ok()) return read.status();
    cut = *std::move(read);
  }

  Parameterization map;
  Status status =
      Parameterize(filled.surface, *targets, cut ? &*cut : nullptr, job.options, control, &map);
  map.certificate.values["peak_memory_mb"] = PeakMemoryInMegabytes();
  map.certificate.seconds["read"] = read_seconds;
  map.certificate.seconds["preflight"] = preflight_seconds;
  if (status.code() == StatusCode::kInvalidInput) return status.In(job.input);
  if (status.code() == StatusCode::kCancelled) return status;
  if (status.ok()) {
    report << Summary(map.certificate);
    const Timer write_timer;
    const Status written =
        WriteMesh(job.output, AttachUv(*soup, *surface, WithoutFill(filled, map.uv)));
    if (!written.ok()) return written;
    map.certificate.seconds["write"] = write_timer.Seconds();
    if (Status s = WriteFlatMetric(job, map.flat); !s.ok()) return s;
    report << fmt::format("wrote       {} ({:.2f} s, {:.0f} MB)\n", job.output, timer.Seconds(),
                          PeakMemoryInMegabytes());
  }
  map.certificate.seconds["process"] = timer.Seconds();
  const std::string certificate = CertificatePath(job);
  if (Status s = WriteFileAtomically(certificate, map.certificate.ToJson()); !s.ok()) return s;
  report << "certificate " << certificate << "\n";
  const InfeasibilityProof& proof = map.certificate.infeasibility;
  if (!proof.empty()) {
    if (Status s = WriteCarriers(CarrierStem(job), filled.surface, proof, report); !s.ok())
      return s;
  }
  return status;
}

}  // namespace cirque

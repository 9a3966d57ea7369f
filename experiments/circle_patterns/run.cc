#include "experiments/circle_patterns/run.h"

#include <sys/resource.h>

#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/atomic_file.h"
#include "cirque/core/text.h"
#include "cirque/core/timer.h"
#include "cirque/intrinsic/flip_back.h"
#include "cirque/io/con_file.h"
#include "cirque/io/io.h"
#include "cirque/mesh/hole_filling.h"
#include "cirque/mesh/preflight.h"
#include "cirque/pipeline/infeasibility_files.h"

#include "experiments/circle_patterns/domains.h"
#include "experiments/circle_patterns/measures.h"
#include "experiments/circle_patterns/prescriptions.h"

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

/// What was asked of the shape, as far as the map has it.
std::string DomainSummary(const Certificate& c) {
  const auto value = [&](const char* name) { return ValueOr(c, name, kUnset); };
  std::string text;
  if (c.values.count("boundary_circle_error")) {
    text += fmt::format(
        "disk        off the circle {:.1e}, centres of mass {:.1e} boundary {:.1e} area, "
        "boundary spread {:.0e}\n",
        value("boundary_circle_error"), value("boundary_centre_of_mass"),
        value("area_centre_of_mass"), value("boundary_spread"));
  }
  if (c.values.count("conformal_modulus")) {
    text += fmt::format("rectangle   conformal modulus {:.12g}, opposite sides differ by {:.1e}\n",
                        value("conformal_modulus"), value("opposite_side_mismatch"));
  }
  return text;
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
    text += fmt::format(
        "cut         {:.0f} cones, {:.0f} seams, length {:.2f}, rotation {:.1e} rad, gap {:.1e}\n",
        value("cones"), value("seams"), value("cut_length"), value("seam_rotation_mismatch"),
        value("seam_gap"));
  }
  if (value("cone_repairs") > 0) {
    text += fmt::format("cones       {:.0f} moved, {:.0f} widened, where they were infeasible\n",
                        value("cones_moved"), value("cones_widened"));
  }
  if (value("refinement_steps") >= 0) {
    text +=
        fmt::format("cones       {:.0f} steps of refinement, area distortion {:.4f} to {:.4f}\n",
                    value("refinement_steps"), value("refinement_area_distortion_before"),
                    value("refinement_area_distortion_after"));
  }
  if (value("map_refinement_steps") >= 0) {
    text += fmt::format("refinement  {:.0f} steps, objective {:.6g} to {:.6g}\n",
                        value("map_refinement_steps"), value("map_refinement_before"),
                        value("map_refinement_after"));
  }
  return text + DomainSummary(c);
}

/// The map of the input's own triangles, and the flat metric if it was asked for.
Status WriteMap(const CirclePatternsJob& job, const PolygonSoup& soup, const Surface& surface,
                const CornerUv& uv, std::ostream& report, Parameterization* map) {
  if (Status s = WriteMesh(job.output, AttachUv(soup, surface, uv)); !s.ok()) return s;
  return job.con.empty() ? Status() : WriteFlatMetric(job, report, map);
}

/// The surface to solve on where holes are to be filled; nothing otherwise.
StatusOr<std::optional<FilledSurface>> FillIfAsked(const CirclePatternsJob& job,
                                                   const Surface& surface, std::ostream& report) {
  if (!job.fill_holes) return std::optional<FilledSurface>();
  StatusOr<FilledSurface> filled = FillHoles(surface, KeptLoops::kLongest);
  if (!filled.ok()) return filled.status().In(job.input);
  report << fmt::format("{} holes filled for the solve\n", filled->num_filled_loops);
  return std::optional<FilledSurface>(*std::move(filled));
}

/// Targets and cut from the job's files, and the map for them.
Status ParameterizeAsAsked(const CirclePatternsJob& job, Index num_file_vertices,
                           const Surface& surface, const SolveControl& control,
                           Parameterization* map) {
  if (job.domain.name != "plane") {
    const Status status = MapToDomain(job, num_file_vertices, surface, control, map);
    return status.code() == StatusCode::kInvalidInput ? status.In(job.input) : status;
  }
  const Triangulation& t = surface.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const StatusOr<std::optional<ConeTargets>> targets =
      PrescribedTargets(job, t, {num_file_vertices, surface.soup_vertex});
  if (!targets.ok()) return targets.status();
  const StatusOr<std::optional<Cut>> cut = PrescribedCut(job, t, lengths, NumbersInFile(surface));
  if (!cut.ok()) return cut.status();
  const Cut* given = *cut ? &**cut : nullptr;
  const Status status = *targets
                            ? Parameterize(surface, **targets, given, job.options, control, map)
                            : ParameterizeWithCones(surface, given, job.options, control, map);
  return status.code() == StatusCode::kInvalidInput ? status.In(job.input) : status;
}

/// The faces and vertices that carry a proof, as a table and as a coloured mesh.
Status WriteCarriers(const std::string& stem, const Surface& surface,
                     const InfeasibilityCertificate& proof, std::ostream& report) {
  const std::string csv = stem + ".infeasible.csv", ply = stem + ".infeasible.ply";
  if (Status s = WriteFileAtomically(csv, InfeasibilityCsv(proof)); !s.ok()) return s;
  if (Status s = WriteFileAtomically(ply, InfeasibilityPly(surface, proof)); !s.ok()) return s;
  report << "carriers    " << csv << ", " << ply << "\n";
  return Status();
}

}  // namespace

Status WriteFlatMetric(const CirclePatternsJob& job, std::ostream& report, Parameterization* map) {
  const FlatSurface& flat = map->flat;
  Status status;
  if (job.flip_back) {
    const FlippedBack back = FlipBack(flat.intrinsic, flat.intrinsic_lengths);
    status = WriteCon(job.con, back.triangulation, back.lengths);
    map->certificate.values["flip_back_stuck"] = static_cast<double>(back.stuck.size());
    report << fmt::format("flip-back   {} of {} flips stay", back.stuck.size(),
                          flat.intrinsic.flips.size());
    report << (back.stuck.empty() ? "\n" : ": edges " + IdList(back.stuck) + " (0-based)\n");
  } else {
    status = WriteCon(job.con, flat.intrinsic.triangulation, flat.intrinsic_lengths);
  }
  if (status.ok()) report << "wrote       " << job.con << "\n";
  return status;
}

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

Status WriteCertificate(const CirclePatternsJob& job, const Surface& surface, const Timer& timer,
                        Certificate* certificate, const Status& status, std::ostream& report) {
  certificate->values["peak_memory_mb"] = PeakMemoryInMegabytes();
  certificate->seconds["process"] = timer.Seconds();
  const std::string path = CertificatePath(job);
  if (Status s = WriteFileAtomically(path, certificate->ToJson()); !s.ok()) return s;
  report << "certificate " << path << "\n";
  const InfeasibilityCertificate& proof = certificate->infeasibility;
  if (!proof.empty()) {
    if (Status s = WriteCarriers(CarrierStem(job), surface, proof, report); !s.ok()) return s;
  }
  return status;
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

  const auto filled = FillIfAsked(job, *surface, report);
  if (!filled.ok()) return filled.status();
  const Surface& solved = *filled ? (*filled)->surface : *surface;

  Parameterization map;
  const Status status =
      ParameterizeAsAsked(job, static_cast<Index>(soup->position.size()), solved, control, &map);
  map.certificate.seconds["read"] = read_seconds;
  map.certificate.seconds["preflight"] = preflight_seconds;
  if (status.code() == StatusCode::kInvalidInput) return status;
  if (status.code() == StatusCode::kCancelled) return status;
  if (status.ok()) {
    report << Summary(map.certificate);
    const Timer write_timer;
    const CornerUv uv = *filled ? WithoutFill(**filled, map.uv) : std::move(map.uv);
    if (Status s = WriteMap(job, *soup, *surface, uv, report, &map); !s.ok()) return s;
    if (Status s = WriteMeasures(job, surface->triangulation, MeasureEdgeLengths(*surface), uv,
                                 surface->position, surface->triangulation.vertex, report);
        !s.ok())
      return s;
    map.certificate.seconds["write"] = write_timer.Seconds();
    report << fmt::format("wrote       {} ({:.2f} s, {:.0f} MB)\n", job.output, timer.Seconds(),
                          PeakMemoryInMegabytes());
  }
  return WriteCertificate(job, solved, timer, &map.certificate, status, report);
}

}  // namespace cirque

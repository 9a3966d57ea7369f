#include "experiments/circle_patterns/outputs.h"

#include <filesystem>

#include <fmt/format.h>

#include "cirque/core/atomic_file.h"
#include "cirque/core/text.h"
#include "cirque/domains/domain.h"
#include "cirque/intrinsic/input_chart.h"
#include "cirque/io/con_file.h"
#include "cirque/io/io.h"
#include "cirque/layout/sphere_chart.h"
#include "cirque/pipeline/infeasibility_files.h"

#include "experiments/common/process.h"
#include "experiments/common/sphere_files.h"

namespace cirque {
namespace {

Status WriteLatLong(const std::string& path, const PolygonSoup& soup, const Surface& surface,
                    const SurfaceMap& map, std::ostream& report) {
  if (path.empty()) return Status();
  const LatLong latlong = LatLongUv(surface.triangulation, map.position);
  if (Status s = WriteMesh(path, AttachUv(soup, surface, latlong.uv)); !s.ok()) return s;
  report << fmt::format("wrote       {} ({} triangles around the poles)\n", path,
                        latlong.at_poles.size());
  return Status();
}

Status WriteSphere(const CirclePatternsJob& job, const Input& input, const SurfaceMap& map,
                   std::ostream& report) {
  const auto& [soup, surface, filled] = input;
  const Status written = MeshExtension(job.output) == "ply"
                             ? WriteFileAtomically(job.output, SpherePly(soup, surface, map))
                             : WriteMesh(job.output, SphereMesh(soup, surface, map.position));
  return written.ok() ? WriteLatLong(job.latlong, soup, surface, map, report) : written;
}

Status WritePlane(const CirclePatternsJob& job, const Input& input, std::ostream& report,
                  SurfaceMap* map) {
  const CornerUv uv = input.filled ? WithoutFill(*input.filled, map->uv) : std::move(map->uv);
  if (Status s = WriteMesh(job.output, AttachUv(input.soup, input.surface, uv)); !s.ok()) return s;
  if (!job.con.empty()) {
    if (Status s = WriteFlatMetric(job, report, map); !s.ok()) return s;
  }
  const Triangulation& t = input.surface.triangulation;
  return WriteMeasures(
      job, {t, MeasureEdgeLengths(input.surface), input.surface.position, t.vertex}, uv, report);
}

/// Whether the names' formats can hold what is to be written.
Status CheckNames(const CirclePatternsJob& job) {
  const StatusOr<Domain> domain = Domains().Find(job.domain.name);
  if (!domain.ok()) return domain.status();
  const bool on_sphere = domain->Gives("position");
  const std::string extension = MeshExtension(job.output);
  if (!job.output.empty() && extension != "obj" && !(on_sphere && extension == "ply")) {
    return Status::InvalidInput(
        job.output + (on_sphere ? ": maps to the sphere are written as .obj or .ply; name it so"
                                : ": maps are written as .obj; name the output so"));
  }
  if (!job.latlong.empty() && MeshExtension(job.latlong) != "obj") {
    return Status::InvalidInput(job.latlong + ": texture is written as .obj; name it so");
  }
  return Status();
}

/// The faces and vertices that carry an infeasibility certificate, as a table and as a coloured mesh.
Status WriteCarriers(const std::string& stem, const Surface& surface,
                     const InfeasibilityCertificate& infeasibility, std::ostream& report) {
  const std::string csv = stem + ".infeasible.csv", ply = stem + ".infeasible.ply";
  if (Status s = WriteFileAtomically(csv, InfeasibilityCsv(infeasibility)); !s.ok()) return s;
  if (Status s = WriteFileAtomically(ply, InfeasibilityPly(surface, infeasibility)); !s.ok())
    return s;
  report << "carriers    " << csv << ", " << ply << "\n";
  return Status();
}

}  // namespace

Status CheckOutputs(const CirclePatternsJob& job) {
  if (Status s = CheckNames(job); !s.ok()) return s;
  std::vector<std::string> paths = {job.output, job.con, job.latlong, CertificatePath(job)};
  for (const MeasureFile& file : job.measures) paths.push_back(file.path);
  for (const std::string& path : paths) {
    if (path.empty()) continue;
    if (Status s = CheckOutputPath(path); !s.ok()) return s;
  }
  return Status();
}

Status WriteOutputs(const CirclePatternsJob& job, const Input& input, std::ostream& report,
                    SurfaceMap* map) {
  return map->IsOnSphere() ? WriteSphere(job, input, *map, report)
                           : WritePlane(job, input, report, map);
}

Status WriteFlatMetric(const CirclePatternsJob& job, std::ostream& report, Parameterization* map) {
  const FlatSurface& flat = map->flat;
  Status status;
  if (job.flip_back) {
    const FlippedBack back = FlipBack(flat.intrinsic, flat.intrinsic_lengths);
    status = WriteCon(job.con, back.triangulation, back.lengths);
    Fill(&map->certificate.triangulation).flip_back_stuck = static_cast<int>(back.stuck.size());
    report << fmt::format("flip-back   {} of {} flips stay", back.stuck.size(),
                          flat.intrinsic.flips.size());
    report << (back.stuck.empty() ? "\n" : ": edges " + IdList(back.stuck) + " (0-based)\n");
  } else {
    status = WriteCon(job.con, flat.intrinsic.triangulation, flat.intrinsic_lengths);
  }
  if (status.ok()) report << "wrote       " << job.con << "\n";
  return status;
}

Status WriteMeasures(const CirclePatternsJob& job, const MeasuredMesh& mesh, const CornerUv& uv,
                     std::ostream& report) {
  if (job.measures.empty()) return Status();
  const MapMeasures measures = MeasureMap(mesh.triangulation, mesh.lengths, uv);
  const Status written = WriteMeasureFiles(job.measures, mesh.position, mesh.corner, measures);
  if (!written.ok()) return written;
  for (const MeasureFile& file : job.measures) report << "measures    " << file.path << "\n";
  return Status();
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
  if (output.starts_with("/dev/")) return "";
  return std::filesystem::path(output).replace_extension(".certificate.json").string();
}

Status WriteCertificate(const CirclePatternsJob& job, const Surface& surface, const Timer& timer,
                        Certificate* certificate, const Status& status, std::ostream& report) {
  certificate->process = ProcessSummary{PeakMemoryMib()};
  certificate->seconds.process = timer.Seconds();
  const std::string path = CertificatePath(job);
  if (path.empty()) return status;
  if (Status s = WriteFileAtomically(path, certificate->ToJson()); !s.ok()) return s;
  report << "certificate " << path << "\n";
  const InfeasibilityCertificate& infeasibility = certificate->infeasibility;
  if (!infeasibility.empty()) {
    if (Status s = WriteCarriers(CarrierStem(job), surface, infeasibility, report); !s.ok())
      return s;
  }
  return status;
}

}  // namespace cirque

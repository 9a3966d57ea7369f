#include "experiments/circle_patterns/outputs.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "cirque/core/atomic_file.h"
#include "cirque/core/text.h"
#include "cirque/domains/domain.h"
#include "cirque/domains/exact_mesh.h"
#include "cirque/intrinsic/input_chart.h"
#include "cirque/io/con_file.h"
#include "cirque/io/io.h"
#include "cirque/io/lattice_texture.h"
#include "cirque/layout/sphere_chart.h"
#include "cirque/pipeline/infeasibility_files.h"

#include "experiments/circle_patterns/pictures.h"
#include "experiments/common/process.h"
#include "experiments/common/sphere_files.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;

/// "3-17, 4-9": the edges that cannot be flipped back, by their vertices from 1.
std::string EndsOf(const FlippedBack& back) {
  constexpr std::size_t kShown = 10;
  const Triangulation& t = back.triangulation;
  std::vector<std::string> ends;
  for (const Index e : back.stuck) {
    if (ends.size() == kShown)
      return Join(ends) + fmt::format(" and {} more", back.stuck.size() - kShown);
    const Index h = t.edge_halfedge[e];
    ends.push_back(fmt::format("{}-{}", t.Tail(h) + 1, t.Tip(h) + 1));
  }
  return Join(ends);
}

bool WantsPictures(const CirclePatternsJob& job) {
  return !job.view.empty() || !job.picture.empty();
}

/// The mesh's name, for the head of a page.
std::string TitleOf(const CirclePatternsJob& job) { return fs::path(job.input).stem().string(); }

Status WriteLatLong(const std::string& path, const Input& input, const SurfaceMap& map,
                    std::ostream& report) {
  const Surface& surface = input.surface;
  if (path.empty()) return Status();
  const LatLong latlong = LatLongUv(surface.triangulation, map.position);
  if (Status s =
          WriteTexturedMesh(path, input.file, AttachUv(input.file.soup, surface, latlong.uv));
      !s.ok()) {
    return s;
  }
  report << fmt::format("wrote       {} ({} triangles around the poles)\n", path,
                        latlong.at_poles.size());
  return Status();
}

/// The input refined by the exact map.
Status WriteExact(const CirclePatternsJob& job, const Input& input, const ExactMap& map,
                  std::ostream& report) {
  const ExactMesh exact = RefineByExactMap(input.file.soup, input.solved, map);
  if (!job.exact.empty()) {
    Status s = exact.sphere.empty() ? WriteMeshInGroups(job.exact, exact.mesh, exact.polygon)
                                    : WriteExactSphere(job.exact, exact);
    if (!s.ok()) return s;
    report << fmt::format("wrote       {} ({} triangles)\n", job.exact, exact.polygon.size());
  }
  if (job.projective.empty()) return Status();
  report << fmt::format("projective  {}, homogeneous texture coordinates\n", job.projective);
  return WriteHomogeneousObj(job.projective, exact.mesh, HomogeneousTexture(exact), exact.polygon);
}

Status WriteSphere(const CirclePatternsJob& job, const Input& input, const SurfaceMap& map,
                   std::ostream& report) {
  const PolygonSoup& soup = input.file.soup;
  const Surface& surface = input.surface;
  const Status written = MeshExtension(job.output) == "ply"
                             ? WriteFileAtomically(job.output, SpherePly(soup, surface, map))
                             : WriteMesh(job.output, SphereMesh(soup, surface, map.position));
  if (!written.ok()) return written;
  if (map.exact_map) {
    if (Status s = WriteExact(job, input, *map.exact_map, report); !s.ok()) return s;
  }
  if (Status s = WriteLatLong(job.latlong, input, map, report); !s.ok()) return s;
  if (!WantsPictures(job)) return Status();
  return WritePictures(job.view, job.picture, TitleOf(job), MakeSphereMap(surface, map.position),
                       map.certificate, report);
}

/// What a texture on the map may repeat by; none: it has seams.
std::optional<LatticeKind> LatticeOf(const Certificate& certificate) {
  if (!certificate.integers || !certificate.integers->integer_gap) return std::nullopt;
  return LatticeOfOrder(certificate.layout->rotation_order.value_or(0));
}

Status WriteTextured(const std::string& path, const Input& input, const CornerUv& uv,
                     std::optional<LatticeKind> lattice) {
  const PolygonSoup textured = AttachUv(input.file.soup, input.surface, uv);
  if (!lattice || MeshExtension(path) != "glb") {
    return WriteTexturedMesh(path, input.file, textured);
  }
  LatticeTexture texture{*lattice, {}};
  for (const auto& [vertex, sum] : MakeUvMap(input.surface, uv).cones) {
    texture.cones.push_back({input.surface.position[vertex], sum});
  }
  return WriteLatticeGlb(path, textured, texture);
}

Status WritePlane(const CirclePatternsJob& job, const Input& input, std::ostream& report,
                  SurfaceMap* map) {
  const CornerUv uv = std::move(map->uv);
  const std::optional<LatticeKind> lattice = LatticeOf(map->certificate);
  if (Status s = WriteTextured(job.output, input, uv, lattice); !s.ok()) return s;
  if (map->exact_map) {
    if (Status s = WriteExact(job, input, *map->exact_map, report); !s.ok()) return s;
  }
  if (!job.con.empty()) {
    if (Status s = WriteFlatMetric(job, report, map); !s.ok()) return s;
  }
  const Triangulation& t = input.surface.triangulation;
  if (!job.measures.empty()) {
    const EdgeLengths lengths = MeasureEdgeLengths(input.surface);
    const Status measured =
        WriteMeasures(job, {t, lengths, input.surface.position, t.vertex}, uv, report);
    if (!measured.ok()) return measured;
  }
  if (!WantsPictures(job)) return Status();
  UvMap image = MakeUvMap(input.surface, uv);
  image.lattice = lattice;
  return WritePictures(job.view, job.picture, TitleOf(job), image, map->certificate, report);
}

/// Whether the names' formats can hold what is to be written.
Status CheckNames(const CirclePatternsJob& job) {
  const std::vector<std::string> known = MapExtensions();
  for (const std::string& output : {job.output, job.exact}) {
    const bool is_known =
        std::find(known.begin(), known.end(), MeshExtension(output)) != known.end();
    if (output.empty() || is_known) continue;
    return Status::InvalidInput(
        fmt::format("{}: a map is written as one of {}; name the output so", output, Join(known)));
  }
  for (const std::string& output : {job.latlong, job.projective}) {
    if (output.empty() || MeshExtension(output) == "obj") continue;
    return Status::InvalidInput(output + ": texture is written as .obj; name it so");
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

/// Whether both names lead to one regular file.
bool IsSameFile(const std::string& a, const std::string& b) {
  std::error_code error;
  return fs::is_regular_file(a, error) && fs::equivalent(a, b, error);
}

Status CheckNotAnInput(const CirclePatternsJob& job, const std::string& output) {
  for (const std::string& input :
       {job.input, job.input_con, job.cones, job.angle_sums, job.cut, job.rotations}) {
    if (job.overwrite || input.empty() || !IsSameFile(output, input)) continue;
    return Status::InvalidInput(fmt::format(
        "{}: this is the input {}; name another output, or give --overwrite", output, input));
  }
  return Status();
}

}  // namespace

Status CheckOutputs(const CirclePatternsJob& job) {
  if (Status s = CheckNames(job); !s.ok()) return s;
  std::vector<std::string> paths = {
      job.output,           job.exact, job.projective,          job.con, job.latlong,
      CertificatePath(job), job.view,  PictureFile(job.picture)};
  for (const MeasureFile& file : job.measures) paths.push_back(file.path);
  for (const std::string& path : paths) {
    if (path.empty()) continue;
    if (Status s = CheckOutputPath(path); !s.ok()) return s;
    if (Status s = CheckNotAnInput(job, path); !s.ok()) return s;
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
    status = WriteCon(job.con, back.triangulation, back.lengths, job.con_form);
    Fill(&map->certificate.triangulation).flip_back_stuck = static_cast<int>(back.stuck.size());
    report << fmt::format("flip-back   {} of {} flips stay", back.stuck.size(),
                          flat.intrinsic.flips.size());
    report << (back.stuck.empty() ? "\n" : ": edges " + EndsOf(back) + " of the .con\n");
  } else {
    status = WriteCon(job.con, flat.intrinsic.triangulation, flat.intrinsic_lengths, job.con_form);
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
  const bool is_asked = !job.certificate.empty();
  if (path.empty() || (!is_asked && certificate->outcome == ToString(StatusCode::kOk))) {
    return status;
  }
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

#include "experiments/circle_patterns/sphere.h"

#include <filesystem>

#include <fmt/format.h>

#include "cirque/core/atomic_file.h"
#include "cirque/core/timer.h"
#include "cirque/io/io.h"
#include "cirque/layout/latlong.h"
#include "cirque/mesh/preflight.h"

#include "experiments/circle_patterns/file_numbering.h"
#include "experiments/common/sphere_files.h"

namespace cirque {
namespace {

std::string Extension(const std::string& path) {
  return std::filesystem::path(path).extension().string();
}

Status CheckJob(const CirclePatternsJob& job, const SphereJob& sphere) {
  const std::string extension = Extension(job.output);
  if (extension != ".obj" && extension != ".ply") {
    return Status::InvalidInput(job.output +
                                ": maps to the sphere are written as .obj or .ply; name it so");
  }
  if (!sphere.latlong.empty() && Extension(sphere.latlong) != ".obj") {
    return Status::InvalidInput(sphere.latlong + ": texture is written as .obj; name it so");
  }
  return Status();
}

std::string Summary(const Certificate& c) {
  const auto value = [&](const char* name) {
    const auto found = c.values.find(name);
    return found == c.values.end() ? kUnset : found->second;
  };
  return fmt::format(
             "pole        vertex {:.0f} of {:.0f} triangles, intersection {:.2e} rad, log range "
             "{:.1f}\n",
             value("pole") + 1, value("pole_corners"), value("delaunay_margin"),
             value("log_radius_range")) +
         fmt::format(
             "map         {:.0f} flipped triangles, {}, quasi-conformal {:.5f} mean {:.4g} max\n",
             value("flipped_triangles"), c.overlap, value("quasi_conformal_mean"),
             value("quasi_conformal_max")) +
         fmt::format(
             "sphere      centre of mass {:.1e}, log area ratio {:.3f} L2, angles {:.2e} rad mean "
             "{:.2e} max\n",
             value("centre_of_mass"), value("log_area_ratio_l2"), value("angle_distortion_mean"),
             value("angle_distortion_max"));
}

Status WriteLatLong(const std::string& path, const PolygonSoup& soup, const Surface& surface,
                    const SphereMap& map, std::ostream& report) {
  if (path.empty()) return Status();
  const LatLong latlong = LatLongUv(surface.triangulation, map.position);
  if (Status s = WriteMesh(path, AttachUv(soup, surface, latlong.uv)); !s.ok()) return s;
  report << fmt::format("wrote       {} ({} triangles around the poles)\n", path,
                        latlong.at_poles.size());
  return Status();
}

Status WriteOutputs(const CirclePatternsJob& job, const SphereJob& sphere, const PolygonSoup& soup,
                    const Surface& surface, const SphereMap& map, std::ostream& report) {
  report << Summary(map.certificate);
  const Status written = Extension(job.output) == ".ply"
                             ? WriteFileAtomically(job.output, SpherePly(soup, surface, map))
                             : WriteMesh(job.output, SphereMesh(soup, surface, map));
  if (!written.ok()) return written;
  report << "wrote       " << job.output << "\n";
  return WriteLatLong(sphere.latlong, soup, surface, map, report);
}

}  // namespace

Status RunSphere(const CirclePatternsJob& job, const SphereJob& sphere, const SolveControl& control,
                 std::ostream& report) {
  const Timer timer;
  if (Status s = CheckJob(job, sphere); !s.ok()) return s;
  const StatusOr<PolygonSoup> soup = ReadMesh(job.input);
  if (!soup.ok()) return soup.status();
  PreflightReport preflight;
  const StatusOr<Surface> surface = Preflight(*soup, &preflight);
  report << preflight.Text();
  if (!surface.ok()) return surface.status().In(job.input);
  SphereOptions options;
  options.principal_axes = sphere.principal_axes;
  options.inversion = sphere.inversion;
  if (!job.domain.normalization.empty()) options.normalization = job.domain.normalization;
  const FileNumbering numbers(*surface, static_cast<Index>(soup->position.size()));
  if (Status s = numbers.Read("pole", job.domain.pole, &options.pole); !s.ok()) return s;

  SphereMap map;
  const Status status = MapToSphere(*surface, options, job.options, control, &map);
  if (status.code() == StatusCode::kInvalidInput) return status.In(job.input);
  if (status.code() == StatusCode::kCancelled) return status;
  if (status.ok()) {
    const Timer write_timer;
    if (Status s = WriteOutputs(job, sphere, *soup, *surface, map, report); !s.ok()) return s;
    map.certificate.seconds["write"] = write_timer.Seconds();
  }
  return WriteCertificate(job, *surface, timer, &map.certificate, status, report);
}

}  // namespace cirque

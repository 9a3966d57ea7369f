// The program on CON files: intrinsic metrics without points.
#include <optional>

#include <fmt/format.h>

#include "cirque/core/atomic_file.h"
#include "cirque/io/con_file.h"
#include "cirque/io/io.h"
#include "cirque/mesh/file_numbers.h"

#include "experiments/circle_patterns/job.h"
#include "experiments/circle_patterns/outputs.h"
#include "experiments/circle_patterns/request.h"

namespace cirque {
namespace {

/// The opened surface in the plane, its points also its texture coordinates.
PolygonSoup PlanarMesh(const Triangulation& t, const Parameterization& map) {
  const Triangulation opened = CutOpen(t, map.cut);
  PolygonSoup soup;
  soup.position.resize(opened.num_vertices);
  soup.texture.resize(opened.num_vertices);
  soup.corner = soup.corner_texture = opened.vertex;
  for (Index h = 0; h < opened.num_halfedges(); ++h) {
    const Eigen::Vector2d& uv = map.uv.value[h];
    soup.texture[opened.vertex[h]] = uv;
    soup.position[opened.vertex[h]] = {uv.x(), uv.y(), 0};
    if (h % 3 == 2) soup.first_corner.push_back(h + 1);
  }
  return soup;
}

Status WriteOutputs(const CirclePatternsJob& job, const Triangulation& t,
                    const EdgeLengths& lengths, std::ostream& report, Parameterization* map) {
  if (!job.con.empty()) {
    if (Status s = WriteFlatMetric(job, report, map); !s.ok()) return s;
  }
  const PolygonSoup planar = PlanarMesh(t, *map);
  if (!job.output.empty()) {
    if (Status s = WriteMesh(job.output, planar); !s.ok()) return s;
    report << "wrote       " << job.output << "\n";
  }
  return WriteMeasures(job, {t, lengths, planar.position, planar.corner}, map->uv, report);
}

}  // namespace

Status RunOnMetric(const CirclePatternsJob& job, const SolveControl& control,
                   std::ostream& report) {
  if (Status s = CheckOutputs(job); !s.ok()) return s;
  const StatusOr<ConMesh> metric = ReadCon(job.input_con);
  if (!metric.ok()) return metric.status();
  const Triangulation& t = metric->triangulation;
  const FileNumbers numbers = OwnNumbers(t);
  const StatusOr<std::optional<Cut>> cut = PrescribedCut(job, t, metric->lengths, numbers);
  if (!cut.ok()) return cut.status();
  Parameterization map;
  Status status;
  if (job.layout_only) {
    status = LayOutFlatMetric(t, metric->lengths, *cut ? &**cut : nullptr, &map);
  } else {
    ParameterizeRequest request{job.options, {}, *cut, {}};
    StatusOr<std::optional<ConeTargets>> targets =
        PrescribedTargets(job, t, {t.num_vertices, numbers.vertex}, &request.cone_rounding);
    if (!targets.ok()) return targets.status();
    request.targets = *std::move(targets);
    auto rotations = RotationsAlongLoops(job, t, numbers);
    if (!rotations.ok()) return rotations.status();
    request.rotations = *std::move(rotations);
    status = Parameterize(t, metric->lengths, request, control, &map);
  }
  if (status.ok()) status = WriteOutputs(job, t, metric->lengths, report, &map);
  status = Status(status.code(), NumberedFromOne(status.message()));
  if (status.code() == StatusCode::kInvalidInput || status.code() == StatusCode::kCancelled) {
    return status.In(job.input_con);
  }
  const std::string certificate = CertificatePath(job);
  if (certificate.empty() || (job.certificate.empty() && status.ok())) return status;
  if (Status s = WriteFileAtomically(certificate, map.certificate.ToJson()); !s.ok()) return s;
  report << "certificate " << certificate << "\n";
  return status;
}

}  // namespace cirque

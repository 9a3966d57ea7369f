#include "cirque/mesh/text_writer.h"

namespace cirque {

void WritePointsAndPolygons(const PolygonSoup& mesh, TextWriter* out) {
  for (const Eigen::Vector3d& point : mesh.position) out->PointLine(point);
  for (Index p = 0; p < mesh.num_polygons(); ++p) {
    out->Number(mesh.first_corner[p + 1] - mesh.first_corner[p]);
    for (Index c = mesh.first_corner[p]; c < mesh.first_corner[p + 1]; ++c) {
      out->Text(" ");
      out->Number(mesh.corner[c]);
    }
    out->Text("\n");
  }
}

}  // namespace cirque

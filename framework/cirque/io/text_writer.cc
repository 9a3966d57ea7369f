#include "cirque/io/text_writer.h"

namespace cirque {

void WritePointsAndPolygons(const PolygonSoup& mesh, TextWriter* out) {
  out->Lines(static_cast<int>(mesh.position.size()),
             [&](int v, TextWriter* line) { line->PointLine(mesh.position[v]); });
  out->Lines(mesh.num_polygons(), [&](int p, TextWriter* line) {
    line->Number(mesh.first_corner[p + 1] - mesh.first_corner[p]);
    for (Index c = mesh.first_corner[p]; c < mesh.first_corner[p + 1]; ++c) {
      line->Text(" ");
      line->Number(mesh.corner[c]);
    }
    line->Text("\n");
  });
}

}  // namespace cirque

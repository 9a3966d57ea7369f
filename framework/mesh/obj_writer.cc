#include "cirque/mesh/obj_writer.h"

#include <utility>

#include "cirque/mesh/text_writer.h"

namespace cirque {
namespace {

template <class Point>
void WritePoints(const char* keyword, const std::vector<Point>& points, TextWriter* out) {
  for (const Point& point : points) {
    out->Text(keyword);
    out->PointLine(point);
  }
}

void WriteCorner(const PolygonSoup& mesh, Index corner, TextWriter* out) {
  out->Text(" ");
  out->Number(mesh.corner[corner] + 1);
  if (mesh.corner_texture.empty() || mesh.corner_texture[corner] == kNone) return;
  out->Text("/");
  out->Number(mesh.corner_texture[corner] + 1);
}

}  // namespace

std::string FormatObj(const PolygonSoup& mesh) {
  TextWriter out;
  WritePoints("v ", mesh.position, &out);
  WritePoints("vt ", mesh.texture, &out);
  for (Index p = 0; p < mesh.num_polygons(); ++p) {
    out.Text("f");
    for (Index c = mesh.first_corner[p]; c < mesh.first_corner[p + 1]; ++c) {
      WriteCorner(mesh, c, &out);
    }
    out.Text("\n");
  }
  return std::move(out).Take();
}

}  // namespace cirque

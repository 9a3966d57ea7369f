#include "cirque/io/obj_writer.h"

#include <utility>

#include "cirque/io/text_writer.h"

namespace cirque {
namespace {

template <class Point>
void WritePoints(const char* keyword, const std::vector<Point>& points, TextWriter* out) {
  out->Lines(static_cast<int>(points.size()), [&](int i, TextWriter* line) {
    line->Text(keyword);
    line->PointLine(points[i]);
  });
}

void WriteCorner(const PolygonSoup& mesh, Index corner, TextWriter* out) {
  out->Text(" ");
  out->Number(mesh.corner[corner] + 1);
  if (mesh.corner_texture.empty() || mesh.corner_texture[corner] == kNone) return;
  out->Text("/");
  out->Number(mesh.corner_texture[corner] + 1);
}

}  // namespace

TextPieces FormatObj(const PolygonSoup& mesh) {
  TextWriter out;
  WritePoints("v ", mesh.position, &out);
  WritePoints("vt ", mesh.texture, &out);
  out.Lines(mesh.num_polygons(), [&](int p, TextWriter* line) {
    line->Text("f");
    for (Index c = mesh.first_corner[p]; c < mesh.first_corner[p + 1]; ++c) {
      WriteCorner(mesh, c, line);
    }
    line->Text("\n");
  });
  return std::move(out).TakePieces();
}

}  // namespace cirque

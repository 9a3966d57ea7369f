#include "cirque/io/off_writer.h"

#include <utility>

#include "cirque/io/text_writer.h"

namespace cirque {

TextPieces FormatOff(const PolygonSoup& mesh) {
  TextWriter out;
  out.Text("OFF\n");
  out.Number(mesh.position.size());
  out.Text(" ");
  out.Number(mesh.num_polygons());
  out.Text(" 0\n");
  WritePointsAndPolygons(mesh, &out);
  return std::move(out).TakePieces();
}

}  // namespace cirque

#include "cirque/io/ply_writer.h"

#include <algorithm>
#include <utility>

#include "cirque/io/text_writer.h"

namespace cirque {
namespace {

Index MostCorners(const PolygonSoup& mesh) {
  Index most = 0;
  for (Index p = 0; p < mesh.num_polygons(); ++p) {
    most = std::max(most, mesh.first_corner[p + 1] - mesh.first_corner[p]);
  }
  return most;
}

}  // namespace

TextPieces FormatPly(const PolygonSoup& mesh) {
  TextWriter out;
  out.Text("ply\nformat ascii 1.0\nelement vertex ");
  out.Number(mesh.position.size());
  out.Text("\nproperty double x\nproperty double y\nproperty double z\nelement face ");
  out.Number(mesh.num_polygons());
  // Many readers know only the usual uchar, which holds 255 corners.
  out.Text(MostCorners(mesh) < 256 ? "\nproperty list uchar int vertex_indices\nend_header\n"
                                   : "\nproperty list int int vertex_indices\nend_header\n");
  WritePointsAndPolygons(mesh, &out);
  return std::move(out).TakePieces();
}

}  // namespace cirque

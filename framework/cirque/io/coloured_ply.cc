#include "cirque/io/coloured_ply.h"

#include <utility>

#include <glog/logging.h>

#include "cirque/io/text_writer.h"

namespace cirque {

std::string FormatColouredPly(const std::vector<Eigen::Vector3d>& position,
                              const std::vector<Index>& corner, const std::vector<Colour>& colour,
                              const std::vector<std::string>& comments) {
  CHECK_EQ(corner.size(), 3 * colour.size());
  TextWriter out;
  out.Text("ply\nformat ascii 1.0\n");
  for (const std::string& comment : comments) out.Text("comment " + comment + "\n");
  out.Text("element vertex ");
  out.Number(position.size());
  out.Text("\nproperty double x\nproperty double y\nproperty double z\nelement face ");
  out.Number(colour.size());
  out.Text(
      "\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nend_header\n");
  for (const Eigen::Vector3d& point : position) out.PointLine(point);
  for (std::size_t f = 0; f < colour.size(); ++f) {
    Eigen::Matrix<Index, 7, 1> line;
    line << 3, corner[3 * f], corner[3 * f + 1], corner[3 * f + 2], colour[f][0], colour[f][1],
        colour[f][2];
    out.PointLine(line);
  }
  return std::move(out).Take();
}

}  // namespace cirque

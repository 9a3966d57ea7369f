#include "experiments/common/sphere_files.h"

#include <utility>

#include "cirque/io/text_writer.h"

namespace cirque {
namespace {

constexpr char kHeaderOfVertices[] =
    "\nproperty double x\nproperty double y\nproperty double z"
    "\nproperty double sx\nproperty double sy\nproperty double sz\nelement face ";
constexpr char kHeaderOfFaces[] =
    "\nproperty list uchar int vertex_indices\nproperty double quasi_conformal"
    "\nproperty double angle_distortion\nend_header\n";

}  // namespace

PolygonSoup SphereMesh(const PolygonSoup& input, const Surface& surface,
                       const std::vector<Eigen::Vector3d>& position) {
  const Triangulation& t = surface.triangulation;
  PolygonSoup soup;
  soup.position.assign(input.position.size(), Eigen::Vector3d::Zero());
  for (Index v = 0; v < t.num_vertices; ++v) {
    soup.position[surface.soup_vertex[v]] = position[v];
  }
  for (const Index v : t.vertex) soup.corner.push_back(surface.soup_vertex[v]);
  for (Index f = 1; f <= t.num_faces(); ++f) soup.first_corner.push_back(3 * f);
  return soup;
}

std::string SpherePly(const PolygonSoup& input, const Surface& surface, const SurfaceMap& map) {
  const PolygonSoup image = SphereMesh(input, surface, map.position);
  TextWriter out;
  out.Text("ply\nformat ascii 1.0\nelement vertex ");
  out.Number(input.position.size());
  out.Text(kHeaderOfVertices);
  out.Number(image.num_polygons());
  out.Text(kHeaderOfFaces);
  for (std::size_t v = 0; v < input.position.size(); ++v) {
    Eigen::Matrix<double, 6, 1> both;
    both << input.position[v], image.position[v];
    out.PointLine(both);
  }
  for (Index f = 0; f < image.num_polygons(); ++f) {
    out.Text("3");
    for (Index c = 3 * f; c < 3 * f + 3; ++c) {
      out.Text(" ");
      out.Number(image.corner[c]);
    }
    out.Text(" ");
    out.PointLine(Eigen::Vector2d(map.quasi_conformal[f], map.angle_distortion[f]));
  }
  return std::move(out).Take();
}

}  // namespace cirque

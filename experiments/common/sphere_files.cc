#include "experiments/common/sphere_files.h"

#include <utility>

#include "cirque/core/atomic_file.h"
#include "cirque/io/io.h"
#include "cirque/io/text_writer.h"

namespace cirque {
namespace {

constexpr char kHeaderOfVertices[] =
    "\nproperty double x\nproperty double y\nproperty double z"
    "\nproperty double sx\nproperty double sy\nproperty double sz\nelement face ";
constexpr char kHeaderOfFaces[] =
    "\nproperty list uchar int vertex_indices\nproperty double quasi_conformal"
    "\nproperty double angle_distortion\nend_header\n";
constexpr char kHeaderOfPieces[] =
    "\nproperty list uchar int vertex_indices\nproperty int input_face\nend_header\n";

/// The head of a PLY, and its points on the surface and on the sphere.
void WritePoints(const std::vector<Eigen::Vector3d>& on_surface,
                 const std::vector<Eigen::Vector3d>& on_sphere, Index faces, const char* of_faces,
                 TextWriter* out) {
  out->Text("ply\nformat ascii 1.0\nelement vertex ");
  out->Number(on_surface.size());
  out->Text(kHeaderOfVertices);
  out->Number(faces);
  out->Text(of_faces);
  for (std::size_t v = 0; v < on_surface.size(); ++v) {
    Eigen::Matrix<double, 6, 1> both;
    both << on_surface[v], on_sphere[v];
    out->PointLine(both);
  }
}

void WriteTriangle(const Index* corner, TextWriter* out) {
  out->Text("3");
  for (int k = 0; k < 3; ++k) {
    out->Text(" ");
    out->Number(corner[k]);
  }
  out->Text(" ");
}

std::string ExactSpherePly(const ExactMesh& exact) {
  TextWriter out;
  WritePoints(exact.mesh.position, exact.sphere, exact.mesh.num_polygons(), kHeaderOfPieces, &out);
  for (Index p = 0; p < exact.mesh.num_polygons(); ++p) {
    WriteTriangle(&exact.mesh.corner[3 * p], &out);
    out.Number(exact.polygon[p]);
    out.Text("\n");
  }
  return std::move(out).Take();
}

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
  WritePoints(input.position, image.position, image.num_polygons(), kHeaderOfFaces, &out);
  for (Index f = 0; f < image.num_polygons(); ++f) {
    WriteTriangle(&image.corner[3 * f], &out);
    out.PointLine(Eigen::Vector2d(map.quasi_conformal[f], map.angle_distortion[f]));
  }
  return std::move(out).Take();
}

Status WriteExactSphere(const std::string& path, const ExactMesh& exact) {
  const std::string extension = MeshExtension(path);
  if (extension == "ply") return WriteFileAtomically(path, ExactSpherePly(exact));
  PolygonSoup image = exact.mesh;
  image.position = exact.sphere;
  if (extension != "obj") return WriteMesh(path, image);
  image.corner_texture = image.corner;
  return WriteHomogeneousObj(path, image, exact.mesh.position, exact.polygon);
}

}  // namespace cirque

#include "experiments/run_experiment/config/remeshing.h"

#include <algorithm>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>
#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/mesh/surface.h"
#include "cirque/openmesh.h"

namespace cirque {
namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

constexpr double kSpare = 1.01;  ///< times the triangles wanted: more are too many

StatusOr<Mesh> MeshOf(const PolygonSoup& triangles) {
  Mesh mesh;
  const auto faces = static_cast<std::size_t>(triangles.num_polygons());
  mesh.reserve(triangles.position.size(), faces + faces / 2, faces);
  for (const Eigen::Vector3d& p : triangles.position) mesh.add_vertex({p.x(), p.y(), p.z()});
  for (std::size_t c = 0; c < triangles.corner.size(); c += 3) {
    const Index* v = &triangles.corner[c];
    const auto added =
        mesh.add_face(Mesh::VertexHandle(v[0]), Mesh::VertexHandle(v[1]), Mesh::VertexHandle(v[2]));
    if (added.is_valid()) continue;
    return Status::InvalidInput(fmt::format(
        "triangle {} does not go into a mesh of OpenMesh: of two vertices more than one "
        "edge joins them",
        c / 3 + 1));
  }
  return mesh;
}

template <class Subdivider>
void SubdivideBy(int times, Mesh* mesh) {
  Subdivider subdivider;
  subdivider.attach(*mesh);
  CHECK(subdivider(times));
  subdivider.detach();
}

using OpenMesh::Subdivider::Uniform::LoopT;
using OpenMesh::Subdivider::Uniform::ModifiedButterflyT;
using OpenMesh::Subdivider::Uniform::Sqrt3T;

struct Scheme {
  std::string name;
  void (*subdivide)(int times, Mesh* mesh);  ///< null: MidpointSubdivision
};

const std::vector<Scheme>& Schemes() {
  static const std::vector<Scheme> kSchemes = {
      {"midpoint", nullptr},
      {"loop", SubdivideBy<LoopT<Mesh, double>>},
      {"sqrt3", SubdivideBy<Sqrt3T<Mesh, double>>},
      {"butterfly", SubdivideBy<ModifiedButterflyT<Mesh, double>>}};
  return kSchemes;
}

}  // namespace

const std::vector<std::string>& SubdivisionSchemes() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const Scheme& scheme : Schemes()) names.push_back(scheme.name);
    return names;
  }();
  return kNames;
}

StatusOr<PolygonSoup> Subdivide(const PolygonSoup& triangles, const std::string& scheme,
                                int times) {
  const auto found = std::find_if(Schemes().begin(), Schemes().end(),
                                  [&](const Scheme& s) { return s.name == scheme; });
  CHECK(found != Schemes().end()) << scheme;
  if (!found->subdivide) return MidpointSubdivision(triangles, times);
  StatusOr<Mesh> mesh = MeshOf(triangles);
  if (!mesh.ok()) return mesh.status();
  found->subdivide(times, &*mesh);
  return FacesOf(*mesh).soup;
}

StatusOr<PolygonSoup> Decimate(const PolygonSoup& triangles, Index wanted) {
  if (triangles.num_polygons() <= wanted) return triangles;
  StatusOr<Mesh> made = MeshOf(triangles);
  if (!made.ok()) return made.status();
  Mesh& mesh = *made;
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadrics;
  decimater.add(quadrics);
  decimater.module(quadrics).unset_max_err();
  CHECK(decimater.initialize());
  decimater.decimate_to_faces(0, static_cast<std::size_t>(wanted));
  mesh.garbage_collection();
  if (static_cast<double>(mesh.n_faces()) > kSpare * wanted + 1) {
    return Status::InvalidInput(
        fmt::format("of {} triangles no fewer than {} can be made by collapses that keep the "
                    "surface a manifold; {} were asked for",
                    triangles.num_polygons(), mesh.n_faces(), wanted));
  }
  return FacesOf(mesh).soup;
}

}  // namespace cirque

#pragma once

/// Meshes of OpenMesh, mapped in place. Header only and for any mesh type, as OpenMesh itself is:
/// with point types of float, double or Eigen; cirque/cirque.h does not reach it, and the library
/// does not need OpenMesh.
///
///   struct Traits : OpenMesh::DefaultTraitsDouble {
///     HalfedgeAttributes(OpenMesh::Attributes::TexCoord2D);
///   };
///   OpenMesh::PolyMesh_ArrayKernelT<Traits> mesh = ...;
///   cirque::StatusOr<cirque::MeshMap> map = cirque::MapOpenMesh({}, {}, &mesh);
///
/// Read from the mesh: its faces and vertices that are not deleted; edges whose status is `feature`,
/// along which the surface is opened; the vertex property "cirque:cone_angle" (double, radians),
/// whose finite values are the angle sums of inner vertices. Written to it: what WriteMap says.
/// Several components and what is no surface are what they are in files (MapSurface).

#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Core/Utils/Property.hh>

#include "cirque/cones/cone.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/core/types.h"
#include "cirque/domains/map_arrays.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/pipeline/certificate.h"

namespace cirque {

/// The properties that are read and written; all but the certificate's numbers are persistent.
inline constexpr char kOpenMeshConeAngle[] = "cirque:cone_angle";  ///< vertex, double [rad]
inline constexpr char kOpenMeshUv[] = "cirque:uv";                 ///< halfedge, Vec2d
inline constexpr char kOpenMeshPosition[] = "cirque:position";     ///< vertex, Vec3d: on the sphere
inline constexpr char kOpenMeshCertificate[] = "cirque:certificate";  ///< mesh, std::string: JSON

/// The faces of a mesh, and where they stand in it. A corner's halfedge is that of its face which
/// ends at its vertex: OpenMesh keeps a corner's texture coordinates there.
struct OpenMeshFaces {
  PolygonSoup soup;
  std::vector<int> vertex;    ///< per vertex of the soup its index in the mesh
  std::vector<int> face;      ///< per polygon
  std::vector<int> halfedge;  ///< per polygon corner
  std::vector<Index> number;  ///< per vertex of the mesh its index in the soup; kNone: deleted
};

/// The faces and vertices that are not deleted, in the mesh's order.
template <class Mesh>
OpenMeshFaces FacesOf(const Mesh& mesh) {
  OpenMeshFaces faces;
  faces.number.assign(mesh.n_vertices(), kNone);
  for (auto v = mesh.vertices_sbegin(); v != mesh.vertices_end(); ++v) {
    faces.number[v->idx()] = static_cast<Index>(faces.vertex.size());
    faces.vertex.push_back(v->idx());
    const auto& p = mesh.point(*v);
    faces.soup.position.emplace_back(p[0], p[1], p[2]);
  }
  for (auto f = mesh.faces_sbegin(); f != mesh.faces_end(); ++f) {
    for (auto h = mesh.cfh_ccwbegin(*f); h.is_valid(); ++h) {
      faces.soup.corner.push_back(faces.number[mesh.to_vertex_handle(*h).idx()]);
      faces.halfedge.push_back(h->idx());
    }
    faces.face.push_back(f->idx());
    faces.soup.first_corner.push_back(static_cast<Index>(faces.soup.corner.size()));
  }
  return faces;
}

/// The mesh's `feature` edges by the soup's vertices, but those of the boundary, open already.
template <class Mesh>
std::vector<std::pair<Index, Index>> FeaturesOf(const Mesh& mesh, const OpenMeshFaces& faces) {
  std::vector<std::pair<Index, Index>> edges;
  if (!mesh.has_edge_status()) return edges;
  for (const int halfedge : faces.halfedge) {
    const OpenMesh::HalfedgeHandle h(halfedge), twin = mesh.opposite_halfedge_handle(h);
    const bool is_first = h.idx() < twin.idx();
    if (!is_first || mesh.is_boundary(twin) || !mesh.status(mesh.edge_handle(h)).feature())
      continue;
    edges.emplace_back(faces.number[mesh.from_vertex_handle(h).idx()],
                       faces.number[mesh.to_vertex_handle(h).idx()]);
  }
  return edges;
}

/// The angle sums that the mesh's property gives to vertices that are not on the boundary.
template <class Mesh>
std::vector<Cone> ConesOf(const Mesh& mesh, const OpenMeshFaces& faces) {
  std::vector<Cone> cones;
  OpenMesh::VPropHandleT<double> angle;
  if (!mesh.get_property_handle(angle, kOpenMeshConeAngle)) return cones;
  for (std::size_t v = 0; v < faces.vertex.size(); ++v) {
    const OpenMesh::VertexHandle handle(faces.vertex[v]);
    const double value = mesh.property(angle, handle);
    if (mesh.is_boundary(handle) || !std::isfinite(value)) continue;
    cones.push_back({static_cast<Index>(v), value, value});
  }
  return cones;
}

/// The property of that name, made persistent; a new one has no values yet.
template <class Handle, class Mesh>
Handle PersistentProperty(const char* name, Mesh* mesh) {
  Handle handle;
  if (!mesh->get_property_handle(handle, name)) mesh->add_property(handle, name);
  mesh->property(handle).set_persistent(true);
  return handle;
}

/// The UVs of a map: as the halfedge property "cirque:uv", exactly, and as the texture coordinates
/// of halfedges where the mesh has those of doubles. Halfedges of no face keep what they had (a new
/// property: zeros); faces that the repair set aside have UVs without area (AttachUv).
template <class Mesh>
void WriteUv(const OpenMeshFaces& faces, const MeshMap& map, Mesh* mesh) {
  using TexCoord = typename Mesh::TexCoord2D;
  constexpr bool exact =
      std::is_same_v<std::decay_t<decltype(std::declval<TexCoord>()[0])>, double>;
  const auto property =
      PersistentProperty<OpenMesh::HPropHandleT<OpenMesh::Vec2d>>(kOpenMeshUv, mesh);
  for (std::size_t c = 0; c < faces.halfedge.size(); ++c) {
    const OpenMesh::HalfedgeHandle halfedge(faces.halfedge[c]);
    const Eigen::Vector2d& p = map.UvOfCorner(c);
    mesh->property(property, halfedge) = OpenMesh::Vec2d(p.x(), p.y());
    if constexpr (exact) {
      if (mesh->has_halfedge_texcoords2D()) mesh->set_texcoord2D(halfedge, TexCoord(p.x(), p.y()));
    }
  }
}

/// A map of the mesh's faces: UVs (WriteUv), or points on the sphere as the vertex property
/// "cirque:position"; the certificate as the mesh property "cirque:certificate" and each of its
/// numbers as "cirque:NAME" (mesh, double).
template <class Mesh>
void WriteMap(const OpenMeshFaces& faces, const MeshMap& map, Mesh* mesh) {
  if (map.position.empty()) {
    WriteUv(faces, map, mesh);
  } else {
    const auto at =
        PersistentProperty<OpenMesh::VPropHandleT<OpenMesh::Vec3d>>(kOpenMeshPosition, mesh);
    for (std::size_t v = 0; v < map.position.size(); ++v) {
      const Eigen::Vector3d& p = map.position[v];
      mesh->property(at, OpenMesh::VertexHandle(faces.vertex[v])) =
          OpenMesh::Vec3d(p.x(), p.y(), p.z());
    }
  }
  OpenMesh::MPropHandleT<std::string> text;
  if (!mesh->get_property_handle(text, kOpenMeshCertificate)) {
    mesh->add_property(text, kOpenMeshCertificate);
  }
  mesh->mproperty(text).set_persistent(true);
  mesh->property(text) = map.certificate.ToJson();
  for (const auto& [name, value] : NumbersOf(map.certificate)) {
    OpenMesh::MPropHandleT<double> number;
    const std::string full = "cirque:" + name;
    if (!mesh->get_property_handle(number, full)) mesh->add_property(number, full);
    mesh->property(number) = value;
  }
}

/// Maps a mesh of any number of components as MapSurface does arrays, and writes the map into it
/// (WriteMap). The options number vertices that are not deleted, from 0; where they name no cones
/// and no cut, those that the mesh bears are taken. Errors: those of MapSurface, which count
/// vertices and faces that are not deleted from 1; the mesh then is as it was.
template <class Mesh>
StatusOr<MeshMap> MapOpenMesh(MapOptions options, const SolveControl& control, Mesh* mesh,
                              MapFailure* failure = nullptr) {
  const OpenMeshFaces faces = FacesOf(*mesh);
  const bool asks = !options.cones.empty() || !options.angle_sums.empty();
  if (!asks && !options.options.AsksForCones()) options.cones = ConesOf(*mesh, faces);
  if (options.cut.empty() && options.cut_paths.empty()) options.cut = FeaturesOf(*mesh, faces);
  StatusOr<MeshMap> map = MapSurface(ArraysOf(faces.soup), options, control, failure);
  if (map.ok()) WriteMap(faces, *map, mesh);
  return map;
}

}  // namespace cirque

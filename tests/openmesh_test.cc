#include "cirque/openmesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

// The last of these stands on the others without including them.
// clang-format off
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Geometry/EigenVectorT.hh>
// clang-format on

#include "cirque/generators/generators.h"
#include "cirque/io/io.h"

#include "tests/common/run_program.h"
#include "tests/common/surfaces.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraitsDouble {
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::TexCoord2D);
  using TexCoord2D = OpenMesh::Vec2d;
};

struct EigenTraits : OpenMesh::DefaultTraits {
  using Point = Eigen::Vector3d;
  using Normal = Eigen::Vector3d;
  using TexCoord2D = Eigen::Vector2d;
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::TexCoord2D);
};

struct FloatTraits : OpenMesh::DefaultTraits {
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::TexCoord2D);
};

// What users make of it: members of their own, status kept with the elements.
struct UsersTraits : OpenMesh::DefaultTraitsDouble {
  VertexAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
  FaceAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  VertexTraits {
   public:
    int weight = 0;
  };
};
class UsersMesh : public OpenMesh::PolyMesh_ArrayKernelT<UsersTraits> {
 public:
  std::string name = "mine";
};

using Meshes =
    ::testing::Types<OpenMesh::TriMesh_ArrayKernelT<>, OpenMesh::PolyMesh_ArrayKernelT<FloatTraits>,
                     OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>,
                     OpenMesh::PolyMesh_ArrayKernelT<EigenTraits>, UsersMesh>;

template <class Mesh>
Mesh MeshOf(const PolygonSoup& soup) {
  using Point = typename Mesh::Point;
  using Scalar = std::decay_t<decltype(std::declval<Point>()[0])>;
  Mesh mesh;
  std::vector<OpenMesh::VertexHandle> vertex;
  for (const Eigen::Vector3d& x : soup.position) {
    vertex.push_back(mesh.add_vertex(
        Point(static_cast<Scalar>(x.x()), static_cast<Scalar>(x.y()), static_cast<Scalar>(x.z()))));
  }
  for (Index p = 0; p < soup.num_polygons(); ++p) {
    std::vector<OpenMesh::VertexHandle> corners;
    for (Index c = soup.first_corner[p]; c < soup.first_corner[p + 1]; ++c) {
      corners.push_back(vertex[soup.corner[c]]);
    }
    mesh.add_face(corners);
  }
  return mesh;
}

PolygonSoup Generated(const char* name, Index triangles) {
  return TrianglesOf(GeneratedSurface(name, triangles));
}

template <class Mesh>
OpenMesh::Vec2d UvAt(const Mesh& mesh, OpenMesh::HalfedgeHandle h) {
  OpenMesh::HPropHandleT<OpenMesh::Vec2d> uv;
  EXPECT_TRUE(mesh.get_property_handle(uv, kOpenMeshUv));
  return mesh.property(uv, h);
}

template <class Mesh>
class OpenMeshBridge : public ::testing::Test {};
TYPED_TEST_SUITE(OpenMeshBridge, Meshes);

TYPED_TEST(OpenMeshBridge, MapsAsTheSameSurfaceIsMapped) {
  TypeParam mesh = MeshOf<TypeParam>(Generated("bumpy_terrain", 300));
  const OpenMeshFaces faces = FacesOf(mesh);
  PreflightReport report;
  const Surface surface = *Preflight(faces.soup, &report);
  const SurfaceMap by_surface = *MapSurface(surface, MapRequest());
  const auto map = MapOpenMesh({}, {}, &mesh);
  ASSERT_TRUE(map.ok()) << map.status().message();
  for (std::size_t c = 0; c < by_surface.uv.value.size(); ++c) {
    const OpenMesh::HalfedgeHandle h(faces.halfedge[surface.soup_corner[c]]);
    EXPECT_EQ(UvAt(mesh, h)[0], by_surface.uv.value[c].x());
    EXPECT_EQ(UvAt(mesh, h)[1], by_surface.uv.value[c].y());
  }
}

TYPED_TEST(OpenMeshBridge, CornersAreWhereOpenMeshKeepsTheirTexture) {
  TypeParam mesh = MeshOf<TypeParam>(Generated("sphere", 200));
  ASSERT_TRUE(MapOpenMesh({}, {}, &mesh).ok());
  double area = 0;
  for (auto f = mesh.faces_begin(); f != mesh.faces_end(); ++f) {
    std::vector<OpenMesh::Vec2d> p;
    for (auto h = mesh.cfh_ccwbegin(*f); h.is_valid(); ++h) p.push_back(UvAt(mesh, *h));
    ASSERT_EQ(p.size(), 3u);
    const double twice = (p[1] - p[0])[0] * (p[2] - p[0])[1] - (p[1] - p[0])[1] * (p[2] - p[0])[0];
    EXPECT_GT(twice, 0);
    area += twice / 2;
  }
  EXPECT_GT(area, 1);
}

TYPED_TEST(OpenMeshBridge, DeletedElementsAreNotThere) {
  TypeParam whole = MeshOf<TypeParam>(Generated("sphere", 200));
  whole.request_vertex_status();
  whole.request_edge_status();
  whole.request_face_status();
  for (int v : {3, 40}) whole.delete_vertex(OpenMesh::VertexHandle(v), false);
  TypeParam packed = whole;
  packed.garbage_collection();
  const OpenMeshFaces with = FacesOf(whole), without = FacesOf(packed);
  ASSERT_LT(without.soup.num_polygons(), static_cast<Index>(whole.n_faces()));
  EXPECT_EQ(with.soup.num_polygons(), without.soup.num_polygons());
  EXPECT_EQ(with.soup.position.size(), without.soup.position.size());
  const auto map = MapOpenMesh({}, {}, &whole);
  ASSERT_TRUE(map.ok()) << map.status().message();
  EXPECT_EQ(map->mesh.corner, with.soup.corner);
}

/// The edges of a shortest path from the boundary vertex `from` to another loop of the boundary,
/// breadth first.
template <class Mesh>
std::vector<OpenMesh::EdgeHandle> PathAcross(const Mesh& mesh, OpenMesh::VertexHandle from) {
  std::vector<OpenMesh::HalfedgeHandle> reached_by(mesh.n_vertices());
  std::vector<bool> seen(mesh.n_vertices(), false);
  std::vector<OpenMesh::VertexHandle> queue = {from};
  seen[from.idx()] = true;
  const OpenMesh::HalfedgeHandle first = mesh.halfedge_handle(from);  // of the boundary
  for (auto h = mesh.next_halfedge_handle(first); h != first; h = mesh.next_halfedge_handle(h)) {
    seen[mesh.from_vertex_handle(h).idx()] = true;
  }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    if (i > 0 && mesh.is_boundary(queue[i])) {
      std::vector<OpenMesh::EdgeHandle> path;
      for (auto v = queue[i]; v != from; v = mesh.from_vertex_handle(reached_by[v.idx()])) {
        path.push_back(mesh.edge_handle(reached_by[v.idx()]));
      }
      return path;
    }
    for (auto h = mesh.cvoh_begin(queue[i]); h.is_valid(); ++h) {
      const OpenMesh::VertexHandle to = mesh.to_vertex_handle(*h);
      if (seen[to.idx()]) continue;
      seen[to.idx()] = true;
      reached_by[to.idx()] = *h;
      queue.push_back(to);
    }
  }
  return {};
}

TYPED_TEST(OpenMeshBridge, SurfacesAreOpenedAlongFeatureEdges) {
  TypeParam mesh = MeshOf<TypeParam>(Generated("annulus", 300));
  mesh.request_edge_status();
  auto start = mesh.vertices_begin();
  while (!mesh.is_boundary(*start)) ++start;
  const std::vector<OpenMesh::EdgeHandle> path = PathAcross(mesh, *start);
  ASSERT_GT(path.size(), 1u);
  for (const OpenMesh::EdgeHandle e : path) mesh.status(e).set_feature(true);
  const auto map = MapOpenMesh({}, {}, &mesh);
  ASSERT_TRUE(map.ok()) << map.status().message();
  int torn = 0;
  for (auto e = mesh.edges_begin(); e != mesh.edges_end(); ++e) {
    if (mesh.is_boundary(*e)) continue;
    const auto h = mesh.halfedge_handle(*e, 0), g = mesh.halfedge_handle(*e, 1);
    // The corners at the end of h: of its own face, and of the face beyond.
    const bool apart = UvAt(mesh, h) != UvAt(mesh, mesh.prev_halfedge_handle(g)) ||
                       UvAt(mesh, g) != UvAt(mesh, mesh.prev_halfedge_handle(h));
    EXPECT_TRUE(!apart || mesh.status(*e).feature());
    torn += apart ? 1 : 0;
  }
  EXPECT_EQ(torn, static_cast<int>(path.size()));
}

TYPED_TEST(OpenMeshBridge, ConeAnglesOfThePropertyAreMet) {
  TypeParam mesh = MeshOf<TypeParam>(Generated("sphere", 600));
  OpenMesh::VPropHandleT<double> angle;
  mesh.add_property(angle, kOpenMeshConeAngle);
  std::vector<int> cones = {0, 50, 120, 260};
  for (auto v = mesh.vertices_begin(); v != mesh.vertices_end(); ++v) {
    mesh.property(angle, *v) = std::numeric_limits<double>::quiet_NaN();
  }
  for (const int v : cones) mesh.property(angle, OpenMesh::VertexHandle(v)) = kPi;
  const auto map = MapOpenMesh({}, {}, &mesh);
  ASSERT_TRUE(map.ok()) << map.status().message();
  for (const int v : cones) {
    double sum = 0;
    for (auto h = mesh.cvih_begin(OpenMesh::VertexHandle(v)); h.is_valid(); ++h) {
      const OpenMesh::Vec2d at = UvAt(mesh, *h);
      const OpenMesh::Vec2d a = UvAt(mesh, mesh.prev_halfedge_handle(*h)) - at;
      const OpenMesh::Vec2d b = UvAt(mesh, mesh.next_halfedge_handle(*h)) - at;
      sum += std::atan2(std::abs(a[0] * b[1] - a[1] * b[0]), a[0] * b[0] + a[1] * b[1]);
    }
    EXPECT_NEAR(sum, kPi, 1e-7);
  }
}

TYPED_TEST(OpenMeshBridge, FailuresLeaveTheMeshAlone) {
  TypeParam mesh = MeshOf<TypeParam>(Generated("sphere", 200));
  OpenMesh::VPropHandleT<double> angle;
  mesh.add_property(angle, kOpenMeshConeAngle);
  for (auto v = mesh.vertices_begin(); v != mesh.vertices_end(); ++v)
    mesh.property(angle, *v) = kPi;
  const auto map = MapOpenMesh({}, {}, &mesh);
  EXPECT_EQ(map.status().code(), StatusCode::kInfeasible);  // Gauss-Bonnet
  OpenMesh::HPropHandleT<OpenMesh::Vec2d> uv;
  EXPECT_FALSE(mesh.get_property_handle(uv, kOpenMeshUv));
}

TYPED_TEST(OpenMeshBridge, TheCertificateIsThere) {
  TypeParam mesh = MeshOf<TypeParam>(Generated("sphere", 200));
  MapOptions options;
  options.domain = "sphere";
  const auto map = MapOpenMesh(options, {}, &mesh);
  ASSERT_TRUE(map.ok()) << map.status().message();
  OpenMesh::MPropHandleT<std::string> text;
  OpenMesh::MPropHandleT<double> flips;
  OpenMesh::VPropHandleT<OpenMesh::Vec3d> at;
  ASSERT_TRUE(mesh.get_property_handle(text, kOpenMeshCertificate));
  ASSERT_TRUE(mesh.get_property_handle(flips, "cirque:flipped_triangles"));
  ASSERT_TRUE(mesh.get_property_handle(at, kOpenMeshPosition));
  EXPECT_EQ(nlohmann::json::parse(mesh.property(text))["outcome"], "ok");
  EXPECT_EQ(mesh.property(flips), 0);
  for (auto v = mesh.vertices_begin(); v != mesh.vertices_end(); ++v) {
    EXPECT_NEAR(mesh.property(at, *v).norm(), 1, 1e-12);
  }
}

TEST(OpenMeshTexture, OfDoublesIsTheMapAndOfFloatsIsLeftAlone) {
  auto exact = MeshOf<OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>>(Generated("blob", 300));
  auto eigen = MeshOf<OpenMesh::PolyMesh_ArrayKernelT<EigenTraits>>(Generated("blob", 300));
  auto rounded = MeshOf<OpenMesh::PolyMesh_ArrayKernelT<FloatTraits>>(Generated("blob", 300));
  for (auto h = rounded.halfedges_begin(); h != rounded.halfedges_end(); ++h) {
    rounded.set_texcoord2D(*h, {7, 7});
  }
  ASSERT_TRUE(MapOpenMesh({}, {}, &exact).ok());
  ASSERT_TRUE(MapOpenMesh({}, {}, &eigen).ok());
  ASSERT_TRUE(MapOpenMesh({}, {}, &rounded).ok());
  for (auto h = exact.halfedges_begin(); h != exact.halfedges_end(); ++h) {
    EXPECT_EQ(exact.texcoord2D(*h), UvAt(exact, *h));
  }
  for (auto h = eigen.halfedges_begin(); h != eigen.halfedges_end(); ++h) {
    EXPECT_EQ(eigen.texcoord2D(*h)[0], UvAt(eigen, *h)[0]);
    EXPECT_EQ(eigen.texcoord2D(*h)[1], UvAt(eigen, *h)[1]);
  }
  for (auto h = rounded.halfedges_begin(); h != rounded.halfedges_end(); ++h) {
    EXPECT_EQ(rounded.texcoord2D(*h), OpenMesh::Vec2f(7, 7));
  }
}

TEST(OpenMeshPolygons, KeepTheirCorners) {
  // A cube of quadrilaterals: diagonals are no edges of the mesh.
  PolygonSoup cube;
  for (int i = 0; i < 8; ++i) cube.position.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  cube.corner = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  for (Index c = 4; c <= 24; c += 4) cube.first_corner.push_back(c);
  auto mesh = MeshOf<OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>>(cube);
  mesh.request_edge_status();
  for (auto e = mesh.edges_begin(); e != mesh.edges_end(); ++e) mesh.status(*e).set_feature(true);
  const auto edges = FeaturesOf(mesh, FacesOf(mesh));
  EXPECT_EQ(edges.size(), 12u);
  for (const auto& [a, b] : edges) EXPECT_EQ(std::popcount(static_cast<unsigned>(a ^ b)), 1);
  for (auto e = mesh.edges_begin(); e != mesh.edges_end(); ++e) mesh.status(*e).set_feature(false);
  ASSERT_TRUE(MapOpenMesh({}, {}, &mesh).ok());
}

TYPED_TEST(OpenMeshBridge, SeveralComponentsWithAFaceOfNoAreaAreMappedAsArraysAre) {
  PolygonSoup soup = Together({Generated("bumpy_terrain", 100), Generated("sphere", 200)});
  const auto last = static_cast<Index>(soup.position.size());
  for (int i = 0; i < 3; ++i) soup.position.emplace_back(100 + i, 0, 0);
  soup.corner.insert(soup.corner.end(), {last, last + 1, last + 2});
  soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
  TypeParam mesh = MeshOf<TypeParam>(soup);
  const OpenMeshFaces faces = FacesOf(mesh);
  ASSERT_EQ(faces.soup.corner, soup.corner);
  const auto by_arrays = MapSurface(ArraysOf(faces.soup));
  const auto map = MapOpenMesh({}, {}, &mesh);
  ASSERT_TRUE(map.ok() && by_arrays.ok()) << map.status().message();
  EXPECT_EQ(map->certificate.components.size(), 2u);
  EXPECT_EQ(map->certificate.mesh_repair->zero_area_faces.size(), 1u);
  for (std::size_t c = 0; c < faces.halfedge.size(); ++c) {
    const OpenMesh::Vec2d at = UvAt(mesh, OpenMesh::HalfedgeHandle(faces.halfedge[c]));
    EXPECT_EQ(Eigen::Vector2d(at[0], at[1]), by_arrays->UvOfCorner(c));
  }
}

TEST(OpenMeshFile, KeepsTheExactUvs) {
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;
  Mesh mesh = MeshOf<Mesh>(Generated("blob", 300));
  ASSERT_TRUE(MapOpenMesh({}, {}, &mesh).ok());
  const TemporaryFolder folder;
  const std::string path = folder.Path("map.om");
  ASSERT_TRUE(OpenMesh::IO::write_mesh(mesh, path));
  Mesh back;
  OpenMesh::HPropHandleT<OpenMesh::Vec2d> uv;
  back.add_property(uv, kOpenMeshUv);
  ASSERT_TRUE(OpenMesh::IO::read_mesh(back, path));
  ASSERT_EQ(back.n_halfedges(), mesh.n_halfedges());
  for (auto h = mesh.halfedges_begin(); h != mesh.halfedges_end(); ++h) {
    EXPECT_EQ(back.property(uv, OpenMesh::HalfedgeHandle(h->idx())), UvAt(mesh, *h));
  }
}

/// The cut of the feature edges as a file has it: from, to and the face between them, from 1.
std::string CutFileOf(const UsersMesh& mesh, const OpenMeshFaces& faces,
                      const std::vector<OpenMesh::EdgeHandle>& path) {
  std::string text;
  for (const OpenMesh::EdgeHandle e : path) {
    const auto h = mesh.halfedge_handle(e, 0);
    const auto face = std::find(faces.face.begin(), faces.face.end(), mesh.face_handle(h).idx());
    text += std::to_string(faces.number[mesh.from_vertex_handle(h).idx()] + 1) + " " +
            std::to_string(faces.number[mesh.to_vertex_handle(h).idx()] + 1) + " " +
            std::to_string(face - faces.face.begin() + 1) + "\n";
  }
  return text;
}

/// Faces without a vertex on the boundary, on the path or on each other, deleted; returns how many.
int DeleteFacesBeside(const std::vector<OpenMesh::EdgeHandle>& path, UsersMesh* mesh) {
  std::vector<bool> kept(mesh->n_vertices(), false);
  for (const OpenMesh::EdgeHandle e : path) {
    for (const int side : {0, 1}) {
      kept[mesh->to_vertex_handle(mesh->halfedge_handle(e, side)).idx()] = true;
    }
  }
  for (const auto v : mesh->vertices()) kept[v.idx()] = kept[v.idx()] || v.is_boundary();
  int deleted = 0;
  for (const auto f : mesh->faces()) {
    auto vertices = f.vertices();
    if (vertices.any_of([&](const auto& v) { return kept[v.idx()]; })) continue;
    for (const auto& v : vertices) {
      for (const auto& beside : v.vertices()) kept[beside.idx()] = true;
    }
    mesh->delete_face(f, false);
    if (++deleted == 2) break;
  }
  return deleted;
}

// Through the bridge and back is bit by bit what comes of the files: the mesh that is left as an OBJ,
// its feature edges as a cut.
TEST(OpenMeshFile, FeatureEdgesAndDeletedFacesGiveTheMapOfTheirFiles) {
  UsersMesh mesh = MeshOf<UsersMesh>(Generated("annulus", 1000));
  auto start = mesh.vertices_begin();
  while (!mesh.is_boundary(*start)) ++start;
  const std::vector<OpenMesh::EdgeHandle> path = PathAcross(mesh, *start);
  ASSERT_GT(path.size(), 1u);
  for (const OpenMesh::EdgeHandle e : path) mesh.status(e).set_feature(true);
  ASSERT_EQ(DeleteFacesBeside(path, &mesh), 2);
  const OpenMeshFaces faces = FacesOf(mesh);
  ASSERT_EQ(faces.soup.num_polygons() + 2, static_cast<Index>(mesh.n_faces()));
  ASSERT_TRUE(MapOpenMesh({}, {}, &mesh).ok());

  const TemporaryFolder folder;
  const std::string in = folder.Path("in.obj"), out = folder.Path("out.obj");
  ASSERT_TRUE(WriteMesh(in, faces.soup).ok());
  const std::string cut = folder.Write("cut.txt", CutFileOf(mesh, faces, path));
  const ProgramResult run = RunProgram("circle_patterns " + in + " " + out + " -ie " + cut);
  ASSERT_EQ(run.exit_status, 0) << run.output;
  const PolygonSoup map = *ReadMesh(out);
  ASSERT_EQ(map.corner, faces.soup.corner);
  for (std::size_t c = 0; c < map.corner.size(); ++c) {
    const OpenMesh::Vec2d uv = UvAt(mesh, OpenMesh::HalfedgeHandle(faces.halfedge[c]));
    EXPECT_EQ(map.texture[map.corner_texture[c]], Eigen::Vector2d(uv[0], uv[1]));
  }
  EXPECT_GT(map.texture.size(), map.position.size());  // opened
}

// Its files of double points, polygons, deleted faces and properties are read exactly.
TEST(OpenMeshFile, IsReadAsItWasWritten) {
  UsersMesh mesh;
  std::vector<UsersMesh::VertexHandle> v;
  for (int i = 0; i < 6; ++i) v.push_back(mesh.add_vertex({i / 3. + 0.1, (i % 3) / 7., i * 1e-9}));
  mesh.add_face({v[0], v[3], v[4], v[1]});
  mesh.add_face({v[1], v[4], v[5]});
  const auto deleted = mesh.add_face({v[1], v[5], v[2]});
  OpenMesh::VPropHandleT<double> angle;
  mesh.add_property(angle, "angle");
  mesh.property(angle).set_persistent(true);
  mesh.delete_face(deleted, false);
  const TemporaryFolder folder;
  const std::string path = folder.Path("mesh.om");
  OpenMesh::IO::Options options = OpenMesh::IO::Options::Status;
  options += OpenMesh::IO::Options::VertexNormal;
  ASSERT_TRUE(OpenMesh::IO::write_mesh(mesh, path, options));
  const StatusOr<PolygonSoup> soup = ReadMesh(path);
  ASSERT_TRUE(soup.ok()) << soup.status().message();
  const OpenMeshFaces faces = FacesOf(mesh);
  EXPECT_EQ(soup->first_corner, faces.soup.first_corner);
  EXPECT_EQ(soup->corner, faces.soup.corner);
  EXPECT_EQ(soup->position, faces.soup.position);
}

}  // namespace
}  // namespace cirque

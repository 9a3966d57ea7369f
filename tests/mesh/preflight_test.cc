#include "cirque/mesh/preflight.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/io/io.h"

#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::MakeSoup;
using ::testing::Pair;

/// What docs/architecture.md and triangulation.h promise of every Triangulation.
void ExpectInvariants(const Triangulation& t) {
  std::set<Index> used(t.vertex.begin(), t.vertex.end());
  EXPECT_EQ(static_cast<Index>(used.size()), t.num_vertices);
  Index edges = 0;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index g = t.twin[h];
    if (g == kNone || h < g) {
      EXPECT_EQ(t.edge[h], edges);
      EXPECT_EQ(t.edge_halfedge[edges++], h);
    }
    if (g == kNone) continue;
    EXPECT_EQ(t.twin[g], h);
    EXPECT_EQ(t.edge[g], t.edge[h]);
    EXPECT_EQ(t.Tail(g), t.Tip(h));
    EXPECT_EQ(t.Tip(g), t.Tail(h));
  }
  EXPECT_EQ(t.num_edges(), edges);
}

Surface Accepted(const PolygonSoup& soup, PreflightReport* report) {
  StatusOr<Surface> surface = Preflight(soup, report);
  EXPECT_TRUE(surface.ok()) << surface.status().message();
  if (!surface.ok()) return {};
  ExpectInvariants(surface->triangulation);
  return *std::move(surface);
}

/// The refusal's text without its first line.
std::string Refused(const PolygonSoup& soup, PreflightReport* report) {
  const StatusOr<Surface> surface = Preflight(soup, report);
  EXPECT_EQ(surface.status().code(), StatusCode::kInvalidInput);
  const std::string& message = surface.status().message();
  EXPECT_THAT(message, HasSubstr("(vertices and faces counted from 1 in the file's order):\n"));
  return message.substr(std::min(message.size(), message.find('\n') + 1));
}

/// The corners of face f, from its least vertex on.
std::vector<Index> Face(const Surface& surface, Index f) {
  const auto first = surface.triangulation.vertex.begin() + 3 * f;
  std::vector<Index> face(first, first + 3);
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

/// Turns polygon p around.
void Turn(PolygonSoup* soup, Index p) {
  std::reverse(soup->corner.begin() + soup->first_corner[p],
               soup->corner.begin() + soup->first_corner[p + 1]);
}

TEST(Preflight, MeasuresKnownSurfaces) {
  struct Known {
    PolygonSoup soup;
    Index vertices, edges, triangles, loops, genus;
  };
  const Known surfaces[] = {
      {testing::OneTriangle(), 3, 3, 1, 1, 0},
      {testing::Tetrahedron(), 4, 6, 4, 0, 0},
      {testing::Torus(), 9, 27, 18, 0, 1},
      {testing::Ring(5, false), 10, 20, 10, 2, 0},
  };
  for (const Known& known : surfaces) {
    PreflightReport report;
    const Surface surface = Accepted(known.soup, &report);
    EXPECT_EQ(report.num_vertices, known.vertices);
    EXPECT_EQ(report.num_edges, known.edges);
    EXPECT_EQ(report.num_triangles, known.triangles);
    EXPECT_EQ(report.boundary_loops, known.loops);
    EXPECT_EQ(report.genus, known.genus);
    EXPECT_EQ(report.components, 1);
    EXPECT_TRUE(report.orientable);
    EXPECT_THAT(report.reoriented_faces, IsEmpty());
    EXPECT_EQ(surface.triangulation.num_edges(), known.edges);
    EXPECT_EQ(static_cast<Index>(BoundaryLoops(surface.triangulation).size()), known.loops);
  }
}

TEST(Preflight, KeepsOrderAndOrientationOfASoundMesh) {
  PreflightReport report;
  const PolygonSoup soup = testing::Tetrahedron();
  const Surface surface = Accepted(soup, &report);
  EXPECT_EQ(surface.triangulation.vertex, soup.corner);
  EXPECT_THAT(surface.soup_vertex, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(surface.soup_polygon, ElementsAre(0, 1, 2, 3));
}

TEST(Preflight, SplitsPolygonsAndKnowsTheirCorners) {
  PreflightReport report;
  const Surface surface =
      Accepted(MakeSoup({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {2, 0, 0}},
                        {{0, 1, 2, 3, 4}, {1, 5, 2}}),
               &report);
  EXPECT_THAT(surface.triangulation.vertex, ElementsAre(4, 0, 1, 3, 4, 1, 3, 1, 2, 1, 5, 2));
  EXPECT_THAT(surface.soup_polygon, ElementsAre(0, 0, 0, 1));
  EXPECT_THAT(surface.soup_corner, ElementsAre(4, 0, 1, 3, 4, 1, 3, 1, 2, 5, 6, 7));
  EXPECT_EQ(report.num_triangles, 4);
}

TEST(Preflight, ChoosesAFanWithoutZeroAreas) {
  // Corners 0, 1, 2 are in line: the fan of corner 0 would begin with a triangle of no area.
  PreflightReport report;
  const Surface surface =
      Accepted(MakeSoup({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2, 3}}), &report);
  EXPECT_THAT(surface.triangulation.vertex, ElementsAre(1, 2, 3, 1, 3, 0));
  EXPECT_THAT(report.zero_area_faces, IsEmpty());
}

TEST(Preflight, DiagonalsOfTwoPolygonsAreTwoEdges) {
  // Both quadrilaterals have the diagonal 0-2; glued by their vertices alone, four triangles would
  // meet there.
  PreflightReport report;
  const Surface surface =
      Accepted(MakeSoup({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}, {{0, 1, 2, 3}, {0, 3, 2, 1}}),
               &report);
  EXPECT_EQ(report.num_edges, 6);
  EXPECT_EQ(report.genus, 0);
  EXPECT_EQ(report.boundary_loops, 0);
  EXPECT_EQ(EulerCharacteristic(surface.triangulation), 2);
}

TEST(Preflight, TurnsTheMinorityOfFaces) {
  for (Index turned = 0; turned < 4; ++turned) {
    PolygonSoup soup = testing::Tetrahedron();
    Turn(&soup, turned);
    PreflightReport report;
    const Surface surface = Accepted(soup, &report);
    EXPECT_THAT(report.reoriented_faces, ElementsAre(turned));
    PreflightReport none;
    const Surface expected = Accepted(testing::Tetrahedron(), &none);
    for (Index f = 0; f < 4; ++f) EXPECT_EQ(Face(surface, f), Face(expected, f));
  }
}

TEST(Preflight, TheFirstOfTwoDisorientedFacesDecides) {
  PreflightReport report;
  const Surface surface = Accepted(
      MakeSoup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 2}}), &report);
  EXPECT_THAT(report.reoriented_faces, ElementsAre(1));
  EXPECT_THAT(Face(surface, 0), ElementsAre(0, 1, 2));
  EXPECT_THAT(Face(surface, 1), ElementsAre(0, 2, 3));
}

TEST(Preflight, SetsIsolatedVerticesAside) {
  PreflightReport report;
  const Surface surface = Accepted(
      MakeSoup({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {9, 9, 9}, {0, 1, 0}}, {{1, 2, 4}}), &report);
  EXPECT_THAT(report.isolated_vertices, ElementsAre(0, 3));
  EXPECT_THAT(report.duplicate_vertices, ElementsAre(3));
  EXPECT_THAT(surface.soup_vertex, ElementsAre(1, 2, 4));
  EXPECT_THAT(surface.triangulation.vertex, ElementsAre(0, 1, 2));
  EXPECT_EQ(surface.position[1], Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(report.Text(),
            "5 vertices, 1 face (1 triangle), 3 edges\n"
            "1 component, orientable, genus 0, 1 boundary loop\n"
            "2 vertices without a face, set aside: 1, 4\n"
            "1 vertex where an earlier one lies (left apart): 4\n");
}

TEST(Preflight, DuplicateVerticesAreLegal) {
  PreflightReport report;
  Accepted(MakeSoup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-0.0, 0, 0}, {0, 1, 0}},
                    {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}),
           &report);
  EXPECT_THAT(report.duplicate_vertices, ElementsAre(3));
}

TEST(Preflight, RefusesOneSidedSurfaces) {
  PreflightReport report;
  const std::string message = Refused(testing::Ring(5, true), &report);
  EXPECT_FALSE(report.orientable);
  EXPECT_EQ(report.genus, 1);
  EXPECT_EQ(report.boundary_loops, 1);
  EXPECT_THAT(report.reoriented_faces, IsEmpty());
  EXPECT_THAT(message, ::testing::MatchesRegex(
                           "- the surface has only one side \\(it is not orientable\\), as shows "
                           "at the edge between vertices [0-9]+-[0-9]+; cut it open into a "
                           "two-sided surface"));
  EXPECT_THAT(report.Text(), HasSubstr("not orientable, 1 crosscap, 1 boundary loop"));
}

TEST(Preflight, RefusesABowtie) {
  PreflightReport report;
  EXPECT_EQ(Refused(MakeSoup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
                             {{0, 1, 2}, {0, 3, 4}}),
                    &report),
            "- 1 vertex where the surface touches itself (the faces there are not one fan): 1; "
            "split the mesh there, or let circle_patterns --repair=safe do it");
  EXPECT_EQ(report.components, 1);
  EXPECT_EQ(report.genus, kNone);
}

TEST(Preflight, RefusesThreeFacesOnAnEdge) {
  PreflightReport report;
  EXPECT_THAT(
      Refused(MakeSoup({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}},
                       {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}),
              &report),
      HasSubstr("- 1 edge with more than two faces, between vertices 1-2; remove the "
                "surplus faces, or let circle_patterns --repair=safe take the sheets apart\n"));
  EXPECT_THAT(report.non_manifold_edges, ElementsAre(Pair(0, 1)));
  EXPECT_THAT(report.non_manifold_vertices, ElementsAre(0, 1));
}

TEST(Preflight, RefusesSeveralComponents) {
  PolygonSoup soup =
      MakeSoup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {6, 1, 0}},
               {{0, 1, 2}, {3, 4, 5}, {5, 4, 6}});
  PreflightReport report;
  EXPECT_EQ(Refused(soup, &report),
            "- 2 components (1 face from face 1 on, 2 faces from face 2 on); keep one of them in a "
            "file");
  EXPECT_EQ(report.components, 2);
  EXPECT_EQ(report.boundary_loops, 2);
  EXPECT_EQ(report.genus, 0);
}

TEST(Preflight, RefusesAnEmptyMesh) {
  PreflightReport report;
  for (const PolygonSoup& soup : {PolygonSoup(), MakeSoup({{0, 0, 0}}, {})}) {
    EXPECT_EQ(Refused(soup, &report),
              "- the mesh has no faces; give a file that lists triangles or polygons");
  }
}

TEST(Preflight, RefusesZeroAreasAtEveryScale) {
  for (const double scale : {1e-300, 1e-160, 1.0, 1e150, 1e300}) {
    SCOPED_TRACE(scale);
    const auto needle = [&](double height) {
      return MakeSoup({{0, 0, 0}, {scale, 0, 0}, {scale / 2, height * scale, 0}}, {{0, 1, 2}});
    };
    PreflightReport report;
    Accepted(needle(2e-12), &report);
    EXPECT_EQ(Refused(needle(5e-13), &report),
              "- 1 face of zero area, whose angles are undefined: 1; collapse an edge of each, or "
              "let circle_patterns --repair=safe set them aside");
  }
  PreflightReport report;
  Refused(MakeSoup({{3, 3, 3}, {3, 3, 3}, {3, 3, 3}}, {{0, 1, 2}}), &report);
  EXPECT_THAT(report.zero_area_faces, ElementsAre(0));
}

TEST(Preflight, SaysWhereTheFirstVertexThatIsNotFiniteStandsInItsFile) {
  const std::map<std::string, std::pair<std::string, std::string>> files = {
      {"a.obj",
       {"v 0 0 0\n\nv 0 0 -1.#IND00\nv inf 0 0\nf 1 2 3\n", "2, 3 (the first at a.obj:3)"}},
      {"a.off", {"OFF 3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n", "2 (the first at a.off:3)"}},
      {"a.stl",
       {"solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e999 0\nendloop\n"
        "endfacet\nendsolid\n",
        "3 (the first at a.stl:6)"}},
      {"a.ply",
       {"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 1.#QNAN\n0 1 0\n3 0 1 2\n",
        "2 (the first at a.ply:11)"}}};
  for (const auto& [path, content] : files) {
    const auto& [text, place] = content;
    const StatusOr<PolygonSoup> soup = ParseMesh(path, text);
    ASSERT_TRUE(soup.ok()) << soup.status().message();
    PreflightReport report;
    EXPECT_THAT(Refused(*soup, &report), HasSubstr("not finite: " + place)) << path;
  }
}

TEST(Preflight, NamesAllProblemsAtOnce) {
  const double nan = std::nan("");
  PreflightReport report;
  EXPECT_EQ(Refused(MakeSoup({{0, 0, 0},
                              {1, 0, 0},
                              {0, 1, 0},
                              {2, 0, 0},
                              {nan, 0, 0},
                              {7, 7, 7},
                              {8, 7, 7},
                              {7, 8, 7}},
                             {{0, 1, 2}, {0, 1, 3}, {0, 2, 2}, {2, 1, 4}, {5, 6, 7, 6}, {5, 6, 7}}),
                    &report),
            "- 1 vertex with coordinates that are not finite: 5; correct them\n"
            "- 2 faces with the same vertex twice: 3, 5; correct them, or let circle_patterns "
            "--repair=safe trim them "
            "or set them aside\n"
            "- 1 face of zero area, whose angles are undefined: 2; collapse an edge of each, or "
            "let circle_patterns --repair=safe set them aside\n"
            "- 2 components (4 faces from face 1 on, 2 faces from face 5 on); keep one of them in "
            "a file");
  EXPECT_THAT(report.repeated_vertex_faces, ElementsAre(2, 4));
  EXPECT_THAT(report.reoriented_faces, ElementsAre(1));
}

}  // namespace
}  // namespace cirque

#include <algorithm>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/mesh/preflight.h"

namespace cirque {
namespace {

constexpr std::size_t kListed = 10;  // ids of one kind in a message

std::string Count(std::size_t number, const std::string& singular, const std::string& plural) {
  return fmt::format("{} {}", number, number == 1 ? singular : plural);
}

/// "1 face", "3 vertices".
std::string Faces(std::size_t n) { return Count(n, "face", "faces"); }
std::string Vertices(std::size_t n) { return Count(n, "vertex", "vertices"); }

/// The ids counted from 1.
std::string Ids(std::vector<Index> ids) {
  for (Index& id : ids) ++id;
  return IdList(ids, kListed);
}

std::string AndMore(std::vector<std::string> words) {
  const std::size_t count = words.size();
  words.resize(std::min(count, kListed));
  return Join(words) + (count > kListed ? fmt::format(" and {} more", count - kListed) : "");
}

std::string Edge(std::pair<Index, Index> edge) {
  return fmt::format("{}-{}", edge.first + 1, edge.second + 1);
}

std::string Edges(const std::vector<std::pair<Index, Index>>& edges) {
  std::vector<std::string> words;
  for (const auto& edge : edges) words.push_back(Edge(edge));
  return AndMore(std::move(words));
}

std::string Components(const std::vector<std::vector<Index>>& components) {
  std::vector<std::string> words;
  for (const std::vector<Index>& polygons : components) {
    words.push_back(
        fmt::format("{} from face {} on", Faces(polygons.size()), polygons.front() + 1));
  }
  return AndMore(std::move(words));
}

std::vector<std::string> VertexAndFaceProblems(const PreflightReport& report) {
  std::vector<std::string> problems;
  if (report.num_polygons == 0) {
    problems.push_back("the mesh has no faces; give a file that lists triangles or polygons");
  }
  if (const auto& ids = report.non_finite_vertices; !ids.empty()) {
    const std::string& at = report.non_finite_at;
    problems.push_back(fmt::format("{} with coordinates that are not finite: {}{}; correct them",
                                   Vertices(ids.size()), Ids(ids),
                                   at.empty() ? "" : " (the first at " + at + ")"));
  }
  if (const auto& ids = report.repeated_vertex_faces; !ids.empty()) {
    problems.push_back(fmt::format("{} with the same vertex twice: {}; remove or correct them",
                                   Faces(ids.size()), Ids(ids)));
  }
  if (const auto& ids = report.zero_area_faces; !ids.empty()) {
    problems.push_back(
        fmt::format("{} of zero area, whose angles are undefined: {}; collapse an edge of each, or "
                    "move a vertex",
                    Faces(ids.size()), Ids(ids)));
  }
  return problems;
}

std::vector<std::string> ConnectivityProblems(const PreflightReport& report,
                                              const std::vector<std::vector<Index>>& components,
                                              std::pair<Index, Index> one_sided_edge) {
  std::vector<std::string> problems;
  if (const auto& edges = report.non_manifold_edges; !edges.empty()) {
    problems.push_back(fmt::format(
        "{} with more than two faces, between vertices {}; remove the surplus faces, or duplicate "
        "the vertices so that the sheets come apart",
        Count(edges.size(), "edge", "edges"), Edges(edges)));
  }
  if (const auto& ids = report.non_manifold_vertices; !ids.empty()) {
    problems.push_back(
        fmt::format("{} where the surface touches itself (the faces there are not one fan): {}; "
                    "split the mesh there, one copy of the vertex for each fan",
                    Vertices(ids.size()), Ids(ids)));
  }
  if (!report.orientable) {
    problems.push_back(fmt::format(
        "the surface has only one side (it is not orientable), as shows at the edge between "
        "vertices {}; cut it open into a two-sided surface",
        Edge(one_sided_edge)));
  }
  if (report.components > 1) {
    problems.push_back(fmt::format("{} components ({}); keep one of them in a file",
                                   report.components, Components(components)));
  }
  return problems;
}

/// A line of the report about ids, or nothing.
std::string Line(const std::vector<Index>& ids, const std::string& what) {
  return ids.empty() ? "" : fmt::format("{}: {}\n", what, Ids(ids));
}

std::string TopologyLine(const PreflightReport& report) {
  const std::string genus = report.genus == kNone ? "not a manifold"
                            : report.orientable
                                ? fmt::format("orientable, genus {}", report.genus)
                                : "not orientable, " + Count(report.genus, "crosscap", "crosscaps");
  return fmt::format("{}, {}, {}\n", Count(report.components, "component", "components"), genus,
                     Count(report.boundary_loops, "boundary loop", "boundary loops"));
}

}  // namespace

std::string DescribeProblems(const PreflightReport& report,
                             const std::vector<std::vector<Index>>& components,
                             std::pair<Index, Index> one_sided_edge) {
  std::vector<std::string> problems = VertexAndFaceProblems(report);
  for (std::string& problem : ConnectivityProblems(report, components, one_sided_edge)) {
    problems.push_back(std::move(problem));
  }
  if (problems.empty()) return "";
  return fmt::format("{} (vertices and faces counted from 1 in the file's order):\n- {}",
                     Count(problems.size(), "problem", "problems"), Join(problems, "\n- "));
}

std::string PreflightReport::Text() const {
  std::string text =
      fmt::format("{}, {} ({}), {}\n", Vertices(num_vertices), Faces(num_polygons),
                  Count(num_triangles, "triangle", "triangles"), Count(num_edges, "edge", "edges"));
  text += TopologyLine(*this);
  text +=
      Line(isolated_vertices, Vertices(isolated_vertices.size()) + " without a face, set aside");
  text += Line(reoriented_faces, Faces(reoriented_faces.size()) + " turned around");
  text += Line(duplicate_vertices,
               Vertices(duplicate_vertices.size()) + " where an earlier one lies (left apart)");
  text += Line(non_finite_vertices, Vertices(non_finite_vertices.size()) + " not finite");
  text += Line(repeated_vertex_faces,
               Faces(repeated_vertex_faces.size()) + " with the same vertex twice");
  text += Line(zero_area_faces, Faces(zero_area_faces.size()) + " of zero area");
  if (!non_manifold_edges.empty()) {
    text +=
        fmt::format("{} with more than two faces: {}\n",
                    Count(non_manifold_edges.size(), "edge", "edges"), Edges(non_manifold_edges));
  }
  text += Line(non_manifold_vertices,
               Vertices(non_manifold_vertices.size()) + " where the surface touches itself");
  return text;
}

}  // namespace cirque

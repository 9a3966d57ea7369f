#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "cirque/core/count.h"
#include "cirque/core/text.h"
#include "cirque/mesh/preflight.h"

namespace cirque {
namespace {

constexpr std::size_t kListed = 10;  // ids of one kind in a message

/// "1 face", "3 vertices".
std::string Faces(std::size_t n) { return Count(n, "face"); }
std::string Vertices(std::size_t n) { return Count(n, "vertex"); }

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
    problems.push_back(
        fmt::format("{} with the same vertex twice: {}; correct them, or let "
                    "circle_patterns --repair=safe trim them or set them aside",
                    Faces(ids.size()), Ids(ids)));
  }
  if (const auto& ids = report.zero_area_faces; !ids.empty()) {
    problems.push_back(
        fmt::format("{} of zero area, whose angles are undefined: {}; collapse an edge of each, or "
                    "let circle_patterns --repair=safe set them aside",
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
        "{} with more than two faces, between vertices {}; remove the surplus faces, or let "
        "circle_patterns --repair=safe take the sheets apart",
        Count(edges.size(), "edge"), Edges(edges)));
  }
  if (const auto& ids = report.non_manifold_vertices; !ids.empty()) {
    problems.push_back(
        fmt::format("{} where the surface touches itself (the faces there are not one fan): {}; "
                    "split the mesh there, or let circle_patterns --repair=safe do it",
                    Vertices(ids.size()), Ids(ids)));
  }
  if (!report.orientable) {
    problems.push_back(DescribeOneSided(one_sided_edge));
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
                                : "not orientable, " + Count(report.genus, "crosscap");
  return fmt::format("{}, {}, {}\n", Count(report.components, "component"), genus,
                     Count(report.boundary_loops, "boundary loop"));
}

}  // namespace

std::string DescribeOneSided(std::pair<Index, Index> edge) {
  return fmt::format(
      "the surface has only one side (it is not orientable), as shows at the edge between vertices "
      "{}; cut it open into a two-sided surface",
      Edge(edge));
}

std::string DescribeProblems(const PreflightReport& report,
                             const std::vector<std::vector<Index>>& components,
                             std::pair<Index, Index> one_sided_edge) {
  std::vector<std::string> problems = VertexAndFaceProblems(report);
  for (std::string& problem : ConnectivityProblems(report, components, one_sided_edge)) {
    problems.push_back(std::move(problem));
  }
  if (problems.empty()) return "";
  return fmt::format("{} (vertices and faces counted from 1 in the file's order):\n- {}",
                     Count(problems.size(), "problem"), Join(problems, "\n- "));
}

std::string PreflightReport::Text() const {
  std::string text = fmt::format("{}, {} ({}), {}\n", Vertices(num_vertices), Faces(num_polygons),
                                 Count(num_triangles, "triangle"), Count(num_edges, "edge"));
  text += TopologyLine(*this);
  text +=
      Line(isolated_vertices, Vertices(isolated_vertices.size()) + " without a face, set aside");
  text += Line(reoriented_faces, Faces(reoriented_faces.size()) + " turned around");
  text += Line(duplicate_vertices,
               Vertices(duplicate_vertices.size()) + " where an earlier one lies (left apart)");
  return text;
}

Index RepairSummary::num_set_aside() const {
  return static_cast<Index>(zero_area_faces.size() + repeated_vertex_faces.size() +
                            duplicate_faces.size());
}

bool RepairSummary::ChangesNothing() const {
  return num_set_aside() == 0 && welded_vertices.empty() && split_vertices.empty() &&
         split_edges.empty();
}

std::string RepairSummary::Text() const {
  const std::string repair = "repair      ", seen = "note        ";
  std::string text;
  text += Line(welded_vertices,
               repair + Vertices(welded_vertices.size()) + " welded to an earlier one");
  text += Line(zero_area_faces, repair + Faces(zero_area_faces.size()) + " of no area set aside");
  text += Line(repeated_vertex_faces,
               repair + Faces(repeated_vertex_faces.size()) + " with a vertex twice set aside");
  text += Line(duplicate_faces, repair + Faces(duplicate_faces.size()) + " set aside, since " +
                                    "an earlier one has the same vertices");
  if (!split_edges.empty()) {
    text += fmt::format("{}{} of more than two faces opened: {}\n", repair,
                        Count(split_edges.size(), "edge"), Edges(split_edges));
  }
  text += Line(split_vertices, repair + Vertices(split_vertices.size()) +
                                   " split, where the surface touched itself");
  text += Line(t_junctions, seen + Count(t_junctions.size(), "T-junction") +
                                ", boundary vertices inside another boundary edge, left");
  if (coincident_edges > 0) {
    text += fmt::format(
        "{}{} where others do: the mesh is not welded there; --repair=weld joins "
        "it\n",
        seen,
        Count(coincident_edges, "boundary edge") + (coincident_edges == 1 ? " lies" : " lie"));
  }
  return text;
}

StatusOr<RepairOptions> ParseRepair(const std::string& text) {
  RepairOptions options;
  const std::size_t colon = text.find(':');
  const auto mode = FromWord<RepairMode>(text.substr(0, colon));
  const auto refuse = [&] {
    return Status::InvalidInput(fmt::format(
        "repair = '{}' is not one of {} or weld:TOLERANCE, from 1e-12 to 1 of the bounding box",
        text, Join(WordsOf<RepairMode>())));
  };
  if (!mode) return refuse();
  options.mode = *mode;
  if (colon == std::string::npos) return options;
  const std::string number = text.substr(colon + 1);
  const char* const last = number.data() + number.size();
  const auto [end, error] = std::from_chars(number.data(), last, options.tolerance);
  const bool in_range =
      options.tolerance == 0 || (options.tolerance >= 1e-12 && options.tolerance <= 1);
  if (*mode != RepairMode::kWeld || error != std::errc() || end != last || !in_range) {
    return refuse();
  }
  return options;
}

}  // namespace cirque

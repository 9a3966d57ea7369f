// Every mesh of ../shared/meshes against the table of its README, which was measured by other
// means. Skipped where the folder is missing.

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/io/io.h"
#include "cirque/mesh/preflight.h"

#include "tests/common/paths.h"

namespace cirque {
namespace {

const std::filesystem::path kFolder = ProjectPath("../shared/meshes");

using Row = std::map<std::string, std::string>;

std::vector<std::string> Cells(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line.substr(1));
  for (std::string cell; std::getline(in, cell, '|');) {
    const std::size_t first = cell.find_first_not_of(' ');
    const std::size_t last = cell.find_last_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

/// The README's first table, a row a mesh.
std::vector<Row> ReadTable() {
  std::ifstream in(kFolder / "README.md");
  std::vector<std::string> head;
  std::vector<Row> rows;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("| ") && !rows.empty()) break;
    if (!line.starts_with("| ")) continue;
    const std::vector<std::string> cells = Cells(line);
    if (head.empty()) {
      head = cells;
    } else {
      Row& row = rows.emplace_back();
      for (std::size_t i = 0; i < cells.size(); ++i) row[head[i]] = cells[i];
    }
  }
  return rows;
}

/// "yes" is 0, "no (5 bad)" is 5.
std::size_t NumBad(const std::string& cell) {
  return cell == "yes" ? 0 : std::stoul(cell.substr(cell.find('(') + 1));
}

void ExpectAgreement(const Row& row, const PreflightReport& report) {
  EXPECT_EQ(report.num_vertices, std::stoi(row.at("V")));
  EXPECT_EQ(report.num_edges, std::stoi(row.at("E")));
  EXPECT_EQ(report.num_triangles, std::stoi(row.at("F")));
  EXPECT_EQ(report.components, std::stoi(row.at("comps")));
  EXPECT_EQ(report.non_manifold_edges.size(), NumBad(row.at("edge-mf")));
  EXPECT_EQ(report.non_manifold_vertices.size(), NumBad(row.at("vertex-mf")));
  // Around an edge of three faces it is a matter of definition which boundary edges follow.
  if (row.at("edge-mf") == "yes") {
    EXPECT_EQ(report.boundary_loops, std::stoi(row.at("loops")));
  }
  EXPECT_EQ(report.zero_area_faces.size() + report.repeated_vertex_faces.size(),
            std::stoul(row.at("zero-area")));
  EXPECT_EQ(report.duplicate_vertices.size(), std::stoul(row.at("dup verts")));
  EXPECT_EQ(report.isolated_vertices.size(), std::stoul(row.at("isolated")));
  if (row.at("orientable") != "-") {
    EXPECT_EQ(report.orientable, row.at("orientable") == "yes");
    EXPECT_EQ(report.reoriented_faces.empty(),
              row.at("oriented") == "yes" || row.at("orientable") == "no");
  }
  const std::string genus = report.orientable ? "" : "N";
  EXPECT_EQ(report.genus == kNone ? "-" : genus + std::to_string(report.genus), row.at("genus"));
}

TEST(SharedMeshes, PreflightAgreesWithTheTable) {
  if (!std::filesystem::exists(kFolder / "README.md")) GTEST_SKIP() << "no " << kFolder;
  const std::vector<Row> rows = ReadTable();
  ASSERT_GT(rows.size(), 10u);
  for (const Row& row : rows) {
    const std::string& name = row.at("file");
    SCOPED_TRACE(name);
    const StatusOr<PolygonSoup> soup = ReadMesh(kFolder / (name + ".obj"));
    ASSERT_TRUE(soup.ok()) << soup.status().message();
    PreflightReport report;
    const StatusOr<Surface> surface = Preflight(*soup, &report);
    ExpectAgreement(row, report);
    const bool sound = row.at("edge-mf") == "yes" && row.at("vertex-mf") == "yes" &&
                       row.at("orientable") == "yes" && row.at("comps") == "1" &&
                       row.at("zero-area") == "0";
    EXPECT_EQ(surface.ok(), sound) << surface.status().message();
  }
}

}  // namespace
}  // namespace cirque

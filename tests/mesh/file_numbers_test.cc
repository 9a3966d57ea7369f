#include "cirque/mesh/file_numbers.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// Vertices 0, 1, 2, 3 are 10, 11, 12, 13 in the file (11 to 14 from 1), faces 0 to 3 are polygons 5,
/// 5, 7, 9.
Surface Numbered() {
  Surface surface;
  surface.soup_vertex = {10, 11, 12, 13};
  surface.soup_polygon = {5, 5, 7, 9};
  return surface;
}

TEST(FileNumbers, AreThoseOfTheFileFromOne) {
  const Surface surface = Numbered();
  const std::pair<const char*, const char*> texts[] = {
      {"cone at vertex 3 (0-based): bad", "cone at vertex 14: bad"},
      {"vertices 0, 2 and 40 more (0-based) lie there", "vertices 11, 13 and 40 more lie there"},
      {"the vertices 3 and 1 (0-based)", "the vertices 14 and 12"},
      {"from vertex 1 (0-based) to vertex 2 (0-based) turns", "from vertex 12 to vertex 13 turns"},
      {"the patch of face 2 (0-based; 12 faces) is", "the patch of face 8 (12 faces) is"},
      {"largest at faces 0, 3 and vertices 1, 2 (0-based); allow",
       "largest at faces 6, 10 and vertices 12, 13; allow"},
      {"faces 1, 2 and 7 more and vertices 3 and 9 more (0-based)",
       "faces 6, 8 and 7 more and vertices 14 and 9 more"},
      {"corners 0, 1 (0-based) must", "corners 11, 12 must"},
      {"7 faces of 12; 3 vertices", "7 faces of 12; 3 vertices"}};
  for (const auto& [before, after] : texts) EXPECT_EQ(NumberedAsInFile(surface, before), after);
}

TEST(FileNumbers, WhatIsNoneOfTheSurfacesStays) {
  for (const char* text : {"vertex 4 (0-based) is new", "vertex -1 (0-based)",
                           "vertices 1, 99 (0-based)", "faces 1 and vertices 77 (0-based)"}) {
    EXPECT_EQ(NumberedAsInFile(Numbered(), text), text);
  }
  EXPECT_EQ(NumberedFromOne("vertex 4 (0-based) is new"), "vertex 5 is new");
}

TEST(FileNumbers, AreInWhatMapSurfaceSays) {
  Surface surface = GeneratedSurface("bumpy_terrain", 200);
  for (Index& number : surface.soup_vertex) number += 1000;  // as behind a thousand isolated ones
  MapRequest request;
  request.domain = "disk";
  const std::vector<bool> on_boundary = BoundaryVertices(surface.triangulation);
  request.shape.centre = static_cast<Index>(
      std::find(on_boundary.begin(), on_boundary.end(), true) - on_boundary.begin());
  Certificate failed;
  const Status status = MapSurface(surface, request, {}, &failed).status();
  EXPECT_THAT(
      status.message(),
      testing::HasSubstr("vertex " + std::to_string(request.shape.centre + 1001) + " lies"));
  EXPECT_EQ(failed.message, status.message());
}

}  // namespace
}  // namespace cirque

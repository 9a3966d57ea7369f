#include "tests/verify/mutations.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cirque::verify {

void ExpectEachIsFound(const Scene& good, const std::function<std::string(const Scene&)>& verdict,
                       const std::string& good_verdict, const std::vector<Fault>& faults) {
  using ::testing::StartsWith;
  EXPECT_THAT(verdict(good), StartsWith(good_verdict));
  for (const Fault& fault : faults) {
    Scene scene = good;
    fault.plant(&scene);
    EXPECT_THAT(verdict(scene), ::testing::AllOf(::testing::Not(StartsWith(good_verdict)),
                                                 ::testing::HasSubstr(fault.finding)))
        << fault.name;
  }
}

void ReverseFaces(PolygonSoup* mesh) {
  for (Index f = 0; f < mesh->num_polygons(); ++f) {
    const Index begin = mesh->first_corner[f], end = mesh->first_corner[f + 1];
    std::reverse(mesh->corner.begin() + begin, mesh->corner.begin() + end);
    if (mesh->corner_texture.empty()) continue;
    std::reverse(mesh->corner_texture.begin() + begin, mesh->corner_texture.begin() + end);
  }
}

void RemoveLastFace(PolygonSoup* mesh) {
  mesh->first_corner.pop_back();
  mesh->corner.resize(mesh->first_corner.back());
  if (!mesh->corner_texture.empty()) mesh->corner_texture.resize(mesh->first_corner.back());
}

}  // namespace cirque::verify

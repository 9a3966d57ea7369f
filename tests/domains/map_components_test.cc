#include "cirque/domains/map_components.h"

#include <atomic>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/core/parallel.h"
#include "cirque/pipeline/finish_layout.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::vector<Surface> ThreeSurfaces() {
  return {FlatStrip(2, 2), GeneratedSurface("bumpy_terrain", 400), FlatStrip(6, 2)};
}

std::vector<ComponentJob> JobsFor(const std::vector<Surface>& surfaces) {
  std::vector<ComponentJob> jobs;
  for (const Surface& surface : surfaces) {
    jobs.push_back({surface, {}, {static_cast<Index>(jobs.size()), 1, 1}});
  }
  return jobs;
}

TEST(MapComponents, EachComesAsItDoesAloneHoweverManyThreads) {
  const std::vector<Surface> surfaces = ThreeSurfaces();
  for (const int threads : {1, 4}) {
    const ThreadLimit limit(threads);
    const std::vector<MappedComponent> mapped = MapComponents(JobsFor(surfaces), {});
    ASSERT_EQ(mapped.size(), 3u);
    for (std::size_t i = 0; i < mapped.size(); ++i) {
      ASSERT_TRUE(mapped[i].status.ok()) << mapped[i].status.message();
      EXPECT_EQ(mapped[i].map.uv.value, MapSurface(surfaces[i], {})->uv.value);
      EXPECT_EQ(mapped[i].map.certificate.component->first_face, static_cast<Index>(i));
    }
  }
}

TEST(MapComponents, OneThatFailsLeavesTheOthers) {
  const std::vector<Surface> surfaces = {FlatStrip(2, 2), RegularPolyhedron(4)};
  std::vector<ComponentJob> jobs = JobsFor(surfaces);
  for (ComponentJob& job : jobs) job.request.domain = "disk";
  std::vector<MappedComponent> mapped = MapComponents(jobs, {});
  EXPECT_TRUE(mapped[0].status.ok());
  EXPECT_EQ(mapped[1].status.code(), StatusCode::kInvalidInput);
  const Certificate all =
      SummarizeComponents({mapped[0].map.certificate, mapped[1].map.certificate});
  EXPECT_EQ(all.outcome, "invalid_input");
  EXPECT_EQ(all.message, mapped[1].status.message());
  EXPECT_EQ(all.atlas->components_failed, 1);
}

TEST(MapComponents, StagesNameTheComponentAndCancellingEndsAll) {
  const std::vector<Surface> surfaces = ThreeSurfaces();
  std::vector<std::string> stages;
  SolveControl control;
  control.on_stage = [&](std::string_view stage) { stages.emplace_back(stage); };
  MapComponents(JobsFor(surfaces), control);
  EXPECT_THAT(stages, Each(AllOf(StartsWith("component "), HasSubstr(" of 3, "))));
  EXPECT_FALSE(stages.empty());
  const std::atomic<bool> cancelled = true;
  for (const MappedComponent& mapped : MapComponents(JobsFor({surfaces[1], surfaces[1]}),
                                                     {.callback = {}, .cancelled = &cancelled})) {
    EXPECT_EQ(mapped.status.code(), StatusCode::kCancelled);
  }
}

TEST(SummarizeComponents, OutcomeOfTheWorstAndSumsOfTheRest) {
  std::vector<Certificate> parts(3);
  for (Certificate& part : parts) {
    part.outcome = "ok";
    part.overlap = "injective";
    part.layout = LayoutSummary();
    part.layout->layout_closure = 1e-12;
    part.layout->cones = 2;
    part.seconds.angles = 1;
  }
  EXPECT_EQ(SummarizeComponents(parts).outcome, "ok");
  parts[1].overlap = "boundary_overlaps";
  parts[2].outcome = "not_converged";
  parts[2].message = "why";
  const Certificate all = SummarizeComponents(parts);
  EXPECT_EQ(all.outcome, "not_converged");
  EXPECT_EQ(all.message, "why");
  EXPECT_EQ(all.overlap, "boundary_overlaps");
  EXPECT_EQ(all.layout->cones, 4);
  EXPECT_EQ(all.seconds.angles, 3);
  EXPECT_EQ(all.atlas->components_failed, 1);
  EXPECT_THAT(all.ToJson(), HasSubstr("\"components\": ["));
  EXPECT_THAT(parts[0].ToJson(), ::testing::Not(HasSubstr("\"components\": [")));
}

}  // namespace
}  // namespace cirque

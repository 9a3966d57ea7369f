#include <atomic>
#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>

#include "cirque/generators/generators.h"
#include "cirque/io/io.h"

#include "experiments/circle_patterns/job.h"
#include "experiments/circle_patterns/outputs.h"

namespace cirque {
namespace {

TEST(CirclePatternsCancel, ACancelledRunWritesNothing) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "circle_patterns_cancel";
  std::filesystem::create_directories(folder);
  CirclePatternsJob job;
  job.input = folder / "in.obj";
  job.output = folder / "out.obj";
  ASSERT_TRUE(WriteMesh(job.input, *GenerateMesh("bumpy_terrain", {200, 1})).ok());
  const std::atomic<bool> cancelled = true;
  std::ostringstream report;
  const Status status = RunOnMesh(job, {{}, &cancelled}, report);
  EXPECT_EQ(status.code(), StatusCode::kCancelled) << status.message();
  EXPECT_EQ(ExitStatus(status.code()), 1);
  EXPECT_FALSE(std::filesystem::exists(job.output));
  EXPECT_FALSE(std::filesystem::exists(CertificatePath(job)));
  // The same job runs when nobody cancels it.
  EXPECT_TRUE(RunOnMesh(job, {}, report).ok());
  EXPECT_TRUE(std::filesystem::exists(job.output));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace cirque

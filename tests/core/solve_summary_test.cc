#include "cirque/core/solve_summary.h"

#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cirque {
namespace {

using testing::HasSubstr;

TEST(SolveSummary, EveryTerminationHasAWordOfItsOwn) {
  std::set<std::string> words;
  for (int i = 0; i <= static_cast<int>(Termination::kUnsupported); ++i) {
    words.insert(ToString(static_cast<Termination>(i)));
  }
  EXPECT_EQ(words.size(), 9u);
  EXPECT_FALSE(words.contains("unknown"));
}

TEST(SolveSummary, WhatWasNotRunDoesNotLookSolved) {
  const SolveSummary summary;
  EXPECT_FALSE(summary.Converged());
  EXPECT_TRUE(std::isnan(summary.final_value));
  EXPECT_TRUE(std::isnan(summary.final_gradient_max));
  EXPECT_THAT(summary.BriefReport(), HasSubstr("not_run"));
  EXPECT_THAT(summary.BriefReport(), HasSubstr("the solver was not called"));
}

TEST(SolveSummary, ReportsSayWhatWasDone) {
  SolveSummary summary;
  summary.strategy = "newton";
  summary.termination = Termination::kConverged;
  summary.message = "gradient small enough";
  summary.final_value = 1.25;
  summary.factorizations = 17;
  summary.cg_iterations = 23;
  summary.iterations = {{1, 4.5, 0.5, 1, 0.1}, {2, 1.25, 1e-13, 0.75, 0.2}};
  EXPECT_TRUE(summary.Converged());
  EXPECT_EQ(summary.num_iterations(), 2);
  const std::string brief = summary.BriefReport(), full = summary.FullReport();
  EXPECT_EQ(brief.find('\n'), std::string::npos);
  EXPECT_THAT(brief, HasSubstr("newton: converged after 2 iterations"));
  EXPECT_THAT(full, HasSubstr(brief));
  for (const char* word : {"17 factorizations", "23 CG iterations", "-> 1.25", "step 0.75"}) {
    EXPECT_THAT(full, HasSubstr(word));
  }
}

TEST(Timer, DoesNotRunBackwards) {
  const Timer timer;
  double last = 0;
  for (int i = 0; i < 1000; ++i) {
    const double now = timer.Seconds();
    EXPECT_GE(now, last);
    last = now;
  }
}

}  // namespace
}  // namespace cirque

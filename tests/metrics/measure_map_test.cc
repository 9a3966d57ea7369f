#include "cirque/metrics/measure_map.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/metrics/distortion_measure.h"

#include "tests/metrics/maps.h"

namespace cirque {
namespace {

using Eigen::Vector2d;
using testing::HasSubstr;

TestMap Bent() {
  return MapOf(Grid(4, 3), [](const Eigen::Vector3d& p) {
    return Vector2d(p.x() + 0.3 * p.y() * p.y(), 1.4 * p.y() + 0.2 * std::sin(p.x()));
  });
}

TEST(MeasureFigures, AreThoseOfAllMeasures) {
  const TestMap map = Bent();
  const MapMeasures all = map.Measure();
  const auto some = MeasureFigures(map.triangulation, map.lengths, map.uv,
                                   {"overlap_area", "angle_error_max", "log_scale_l2"});
  ASSERT_TRUE(some.ok()) << some.status().message();
  ASSERT_EQ(some->size(), 3u);
  for (const auto& [name, value] : *some) EXPECT_EQ(value, all.ValueOf(name)) << name;
  EXPECT_GT(some->at("angle_error_max"), 0.01);
  const auto every = MeasureFigures(map.triangulation, map.lengths, map.uv, FigureNames());
  ASSERT_TRUE(every.ok());
  EXPECT_EQ(every->size(), all.figures.size());
}

TEST(MeasureFigures, NamesTheNearestToAnUnknownOne) {
  const TestMap map = Bent();
  const auto refused =
      MeasureFigures(map.triangulation, map.lengths, map.uv, {"cut_length", "log_scale_l3"});
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.status().message(), HasSubstr("unknown quality figure 'log_scale_l3'"));
  EXPECT_THAT(refused.status().message(), HasSubstr("did you mean 'log_scale_l2'?"));
}

TEST(DistortionMeasures, AnUnknownOneIsNamed) {
  EXPECT_THAT(DistortionMeasures().Find("overlop").status().message(),
              HasSubstr("unknown distortion measure 'overlop'; did you mean 'overlap'?"));
}

TEST(FormatFigures, HasALineForEachUnderTheHeadingOfItsGroup) {
  const MapMeasures measures = Bent().Measure();
  const std::string text = FormatFigures(measures);
  std::size_t last = 0;
  for (const char* heading : {"angles\n", "\nareas\n", "\nlengths\n", "\ninjectivity\n"}) {
    const std::size_t at = text.find(heading);
    ASSERT_NE(at, std::string::npos) << heading;
    EXPECT_EQ(text.find(heading, at + 1), std::string::npos) << heading;
    EXPECT_GE(at, last);
    last = at;
  }
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'),
            static_cast<std::ptrdiff_t>(measures.figures.size()) + 4);
  for (const auto& figure : measures.figures) {
    EXPECT_THAT(text, HasSubstr("  " + figure.name + " "));
    EXPECT_THAT(text, HasSubstr("  " + figure.meaning + "\n"));
  }
}

TEST(Statistics, PercentilesAreWeightedByArea) {
  Eigen::VectorXd area(4), value(4);
  area << 0.1, 0.2, 0.3, 0.4;
  value << 7, 1, 5, 3;
  // In order: 1 (0.2), 3 (0.6), 5 (0.9), 7 (1).
  EXPECT_EQ(AreaPercentiles(area, value, {0.1, 0.5, 0.85, 0.95}),
            (std::vector<double>{1, 3, 5, 7}));
  EXPECT_EQ(AreaPercentiles(area, value, {0, 1}), (std::vector<double>{1, 7}));
  EXPECT_DOUBLE_EQ(AreaMean(area, value), 0.7 + 0.2 + 1.5 + 1.2);
  EXPECT_EQ(Smallest(value), 1);
  EXPECT_EQ(Largest(value), 7);
}

TEST(Statistics, OfNothingAreNaN) {
  const Eigen::VectorXd none;
  EXPECT_TRUE(std::isnan(Smallest(none)));
  EXPECT_TRUE(std::isnan(Largest(none)));
  EXPECT_TRUE(std::isnan(AreaMean(none, none)));
  const std::vector<double> percentiles = AreaPercentiles(none, none, {0.5, 0.9});
  ASSERT_EQ(percentiles.size(), 2u);
  for (const double percentile : percentiles) EXPECT_TRUE(std::isnan(percentile));
}

}  // namespace
}  // namespace cirque

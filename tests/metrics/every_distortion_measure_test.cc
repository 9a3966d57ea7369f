// What holds for every registered distortion measure, on maps that are conformal, distorted,
// flipped, folded and torn.
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/metrics/distortion_measure.h"

#include "tests/metrics/maps.h"

namespace cirque {
namespace {

using Eigen::Vector2d;

constexpr double kSmall = 1e-9;

struct Sample {
  std::string name;
  Surface surface;
  TestMap map;
};

/// Moves the images of some faces away: the map is torn along their edges.
void Tear(const Surface& surface, TestMap* map) {
  for (Index f = 0; f < surface.triangulation.num_faces(); ++f) {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      centre += surface.position[surface.triangulation.vertex[h]] / 3;
    }
    if (centre.x() < 0.3) continue;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) map->uv.value[h] += Vector2d(0.05, 0.9);
  }
}

const std::vector<Sample>& Samples() {
  static const std::vector<Sample> kTable = [] {
    const Surface hill = GeneratedSurface("bumpy_terrain", 300);
    const auto bend = [](const Eigen::Vector3d& p) {
      return Vector2d(p.x() + 0.3 * p.y() * p.y(), 1.4 * p.y() + 0.2 * std::sin(3 * p.x()));
    };
    const auto fold = [](const Eigen::Vector3d& p) {
      return Vector2d(std::abs(p.x() - 0.41) + 0.1 * p.y(), p.y() + 0.5 * p.z());
    };
    std::vector<Sample> samples = {{"identity", Grid(3, 2), DroppedToPlane(Grid(3, 2))},
                                   {"bent", hill, MapOf(hill, bend)},
                                   {"folded", hill, MapOf(hill, fold)},
                                   {"torn", hill, MapOf(hill, fold)}};
    Tear(hill, &samples.back().map);
    return samples;
  }();
  return kTable;
}

class EveryDistortionMeasure : public testing::TestWithParam<std::string> {
 protected:
  EveryDistortionMeasure() : measure_(*DistortionMeasures().Find(GetParam())) {}

  Measurement MeasureBy(const TestMap& map) const {
    return measure_.measure(MeasureFaces(map.triangulation, map.lengths, map.uv));
  }

  /// The figures agree, up to the power of `scale` that each is documented to grow with.
  void ExpectSameFigures(const Measurement& expected, const Measurement& found, double scale = 1) {
    ASSERT_EQ(found.figures.size(), measure_.figures.size());
    for (std::size_t i = 0; i < measure_.figures.size(); ++i) {
      const double value = expected.figures[i] * std::pow(scale, measure_.figures[i].length_power);
      EXPECT_TRUE(std::isfinite(value));
      EXPECT_NEAR(found.figures[i], value, kSmall * (1 + std::abs(value)))
          << measure_.figures[i].name;
    }
  }

  void ExpectSameFaceValues(const Measurement& expected, const Measurement& found) {
    ASSERT_EQ(found.face_values.size(), expected.face_values.size());
    for (Eigen::Index f = 0; f < expected.face_values.size(); ++f) {
      const double value = expected.face_values[f];
      EXPECT_NEAR(found.face_values[f], value, kSmall * (1 + std::abs(value))) << f;
    }
  }

  bool AxisAligned() const {
    return std::any_of(measure_.figures.begin(), measure_.figures.end(),
                       [](const FigureSpec& spec) { return spec.axis_aligned; });
  }

  const DistortionMeasure measure_;
};

TEST_P(EveryDistortionMeasure, ScaleOfTheSurfaceMattersAsDocumented) {
  for (const Sample& sample : Samples()) {
    SCOPED_TRACE(sample.name);
    TestMap scaled = sample.map;
    scaled.lengths.value *= 37;
    const Measurement expected = MeasureBy(sample.map), found = MeasureBy(scaled);
    ExpectSameFigures(expected, found, 37);
    ExpectSameFaceValues(expected, found);
  }
}

TEST_P(EveryDistortionMeasure, ScalePlaceAndTurnOfTheImageDoNotMatter) {
  const double angle = AxisAligned() ? kPi / 2 : 0.7;
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  for (const Sample& sample : Samples()) {
    SCOPED_TRACE(sample.name);
    TestMap moved = sample.map, mirrored = sample.map;
    for (Vector2d& p : moved.uv.value) p = 0.03 * (turn * p) + Vector2d(2, -5);
    for (Vector2d& p : mirrored.uv.value) p.x() = -p.x();
    const Measurement expected = MeasureBy(sample.map);
    ExpectSameFigures(expected, MeasureBy(moved));
    ExpectSameFaceValues(expected, MeasureBy(moved));
    ExpectSameFigures(expected, MeasureBy(mirrored));
  }
}

TEST_P(EveryDistortionMeasure, MidpointSubdivisionLeavesThePiecewiseLinearMapAsItIs) {
  for (const Sample& sample : Samples()) {
    SCOPED_TRACE(sample.name);
    const Measurement expected = MeasureBy(sample.map);
    const Measurement found = MeasureBy(Subdivided(sample.surface, sample.map.uv));
    ExpectSameFigures(expected, found);
    for (Eigen::Index f = 0; f < found.face_values.size(); ++f) {
      const double value = expected.face_values[f / 4];
      EXPECT_NEAR(found.face_values[f], value, kSmall * (1 + std::abs(value))) << f;
    }
  }
}

/// The map with its faces in reverse order, every face from its second corner on, and its vertices
/// numbered backwards.
TestMap Renumbered(const TestMap& map) {
  const Triangulation& t = map.triangulation;
  const auto moved = [&](Index h) {
    return h == kNone ? kNone : 3 * (t.num_faces() - 1 - h / 3) + (h + 2) % 3;
  };
  std::vector<Index> vertex(t.num_halfedges()), twin(t.num_halfedges());
  TestMap result;
  result.uv.value.resize(t.num_halfedges());
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    vertex[moved(h)] = t.num_vertices - 1 - t.vertex[h];
    twin[moved(h)] = moved(t.twin[h]);
    result.uv.value[moved(h)] = map.uv.value[h];
  }
  result.triangulation = NumberEdges(t.num_vertices, vertex, twin);
  result.lengths.value.resize(t.num_edges());
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    result.lengths.value[result.triangulation.edge[moved(h)]] = map.lengths.value[t.edge[h]];
  }
  return result;
}

TEST_P(EveryDistortionMeasure, NumberingDoesNotMatter) {
  for (const Sample& sample : Samples()) {
    SCOPED_TRACE(sample.name);
    const Measurement expected = MeasureBy(sample.map);
    Measurement found = MeasureBy(Renumbered(sample.map));
    found.face_values.reverseInPlace();
    ExpectSameFigures(expected, found);
    ExpectSameFaceValues(expected, found);
  }
}

TEST_P(EveryDistortionMeasure, TellsSomeMapFromTheIdentity) {
  std::vector<std::set<double>> values(measure_.figures.size());
  for (const Sample& sample : Samples()) {
    Measurement found = MeasureBy(sample.map);
    for (std::size_t i = 0; i < values.size(); ++i) values[i].insert(found.figures[i]);
    TestMap collapsed = sample.map;
    for (Index h = 0; h < 3; ++h) collapsed.uv.value[h] = Vector2d(0, 0);
    found = MeasureBy(collapsed);
    for (std::size_t i = 0; i < values.size(); ++i) values[i].insert(found.figures[i]);
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_GT(values[i].size(), 1u) << measure_.figures[i].name;
  }
}

TEST_P(EveryDistortionMeasure, HasNoFigureWhereNoFaceCanBeMeasured) {
  TestMap collapsed = DroppedToPlane(Grid(2, 1));
  for (Vector2d& p : collapsed.uv.value) p = Vector2d(1, 1);
  const Measurement found = MeasureBy(collapsed);
  EXPECT_EQ(found.face_values.size(), 0);
  for (const double figure : found.figures) {
    EXPECT_EQ(std::isnan(figure), GetParam() != "degenerate");
  }
}

TEST_P(EveryDistortionMeasure, SaysWhatItMeasures) {
  EXPECT_THAT(measure_.group, testing::AnyOf("angles", "areas", "lengths", "injectivity"));
  EXPECT_LT(measure_.least, measure_.greatest);
  EXPECT_EQ(measure_.face_meaning.empty(), MeasureBy(Samples()[1].map).face_values.size() == 0);
  EXPECT_FALSE(measure_.figures.empty());
  for (const FigureSpec& spec : measure_.figures) EXPECT_FALSE(spec.meaning.empty());
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryDistortionMeasure,
                         testing::ValuesIn(DistortionMeasures().Names()),
                         [](const auto& measure) { return measure.param; });

TEST(DistortionMeasures, FiguresHaveNamesOfTheirOwn) {
  const std::vector<std::string> names = FigureNames();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  EXPECT_THAT(names, testing::IsSupersetOf({"quasi_conformal_mean", "overlap_area", "cut_length"}));
}

}  // namespace
}  // namespace cirque

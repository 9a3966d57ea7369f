#include "cirque/cuts/charts.h"

#include <atomic>
#include <cmath>

#include <gtest/gtest.h>

#include "cirque/metrics/injectivity.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

Cut NoCut(const Triangulation& t) { return {std::vector<bool>(t.num_edges(), false)}; }

/// A strip wound round the origin by so many turns, without flips; from the first turn on it lies
/// upon itself.
CornerUv Wound(const Surface& strip, double turns) {
  const double length = strip.position.back().x();
  CornerUv uv;
  for (const Index v : strip.triangulation.vertex) {
    const double angle = 2 * kPi * turns * (1 - strip.position[v].x() / length);
    const double radius = 3 + strip.position[v].y() + 0.05 * angle;
    uv.value.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return uv;
}

Index ChartsOf(const Triangulation& t, const Cut& cut) {
  return ConnectedPatches(CutOpen(t, cut)).count;
}

/// The image with its charts far apart.
CornerUv Apart(const Triangulation& t, const Cut& cut, CornerUv uv) {
  const Patches charts = ConnectedPatches(CutOpen(t, cut));
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    uv.value[h].x() += 100 * charts.of_face[Triangulation::Face(h)];
  }
  return uv;
}

TEST(CutIntoCharts, AWoundStripComesInAsManyChartsAsItHasTurnsBegun) {
  const Surface strip = FlatStrip(60, 2);
  const Triangulation& t = strip.triangulation;
  for (const auto& [turns, charts] : {std::pair(0.9, 1), {1.3, 2}, {1.9, 2}, {2.5, 3}}) {
    SCOPED_TRACE(turns);
    const CornerUv uv = Wound(strip, turns);
    ASSERT_TRUE(FlippedFaces(t, uv).empty());
    EXPECT_EQ(OverlapsItself(t, uv), charts > 1);
    const Cut cut = *CutIntoCharts({t, NoCut(t), uv});
    EXPECT_EQ(ChartsOf(t, cut), charts);
    EXPECT_FALSE(OverlapsItself(CutOpen(t, cut), Apart(t, cut, uv)));
  }
}

// The strip of two rows is parted across, by two edges, one where one of them is twice as long.
TEST(CutIntoCharts, PartsSheetsByAShortCut) {
  const Surface strip = FlatStrip(60, 2);
  const Triangulation& t = strip.triangulation;
  const Cut cut = *CutIntoCharts({t, NoCut(t), Wound(strip, 1.5)});
  EXPECT_EQ(std::count(cut.edge.begin(), cut.edge.end(), true), 2);
}

TEST(CutIntoCharts, ClosedEdgesStayClosedWhereOthersWillDo) {
  const Surface strip = FlatStrip(60, 2);
  const Triangulation& t = strip.triangulation;
  std::vector<bool> closed(t.num_edges(), false);
  for (Index e = 0; e < t.num_edges(); ++e) {
    const auto at = [&](Index v) { return strip.position[v]; };
    const Index h = t.edge_halfedge[e];
    closed[e] = (at(t.Tail(h)) - at(t.Tip(h))).norm() > 1.1;  // the diagonals of the squares
  }
  const Cut cut = *CutIntoCharts({t, NoCut(t), Wound(strip, 1.5), &closed});
  EXPECT_EQ(ChartsOf(t, cut), 2);
  for (Index e = 0; e < t.num_edges(); ++e) EXPECT_FALSE(closed[e] && cut.edge[e]);
}

TEST(CutIntoCharts, StopsWhenCancelled) {
  const Surface strip = FlatStrip(60, 2);
  const Triangulation& t = strip.triangulation;
  const std::atomic<bool> cancelled = true;
  EXPECT_EQ(CutIntoCharts({t, NoCut(t), Wound(strip, 1.5)}, &cancelled).status().code(),
            StatusCode::kCancelled);
}

}  // namespace
}  // namespace cirque

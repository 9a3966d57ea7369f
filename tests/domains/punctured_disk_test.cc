// The parts of a map to the disk: the pole's star taken off, what the rest is asked for.
#include "cirque/domains/punctured_disk.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "cirque/domains/disk_placement.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

constexpr double kEpsilon = 1e-3;

/// A disk with the star of its k-th boundary vertex taken off.
struct Case {
  explicit Case(Surface of, std::size_t k = 5)
      : surface(std::move(of)),
        lengths(MeasureEdgeLengths(surface)),
        measured(MeasureSurface(surface.triangulation, lengths)) {
    const Triangulation& t = surface.triangulation;
    const std::vector<Index> loop = BoundaryLoops(t).front();
    pole = t.Tail(loop[k % loop.size()]);
    disk = TakeOffStar(t, lengths, LargestChordlessPiece(t, measured.boundary), pole, kEpsilon);
  }
  Case(const Case&) = delete;

  Surface surface;
  EdgeLengths lengths;
  IntrinsicSurface measured;
  Index pole = kNone;
  PuncturedDisk disk;
};

TEST(TakeOffStar, LeavesTheFacesThatDoNotTouchThePole) {
  const Case c(GeneratedSurface("hemisphere", 500));
  const Triangulation& t = c.surface.triangulation;
  const auto around = std::count(t.vertex.begin(), t.vertex.end(), c.pole);
  EXPECT_EQ(c.disk.rest.triangulation.num_faces(), t.num_faces() - around);
  EXPECT_EQ(c.disk.rest.of_vertex[c.pole], kNone);
  EXPECT_EQ(EulerCharacteristic(c.disk.rest.triangulation), 1);
  for (std::size_t v = 0; v < c.disk.rest.vertex.size(); ++v) {
    EXPECT_EQ(c.disk.rest.of_vertex[c.disk.rest.vertex[v]], static_cast<Index>(v));
  }
}

TEST(TakeOffStar, TheBoundaryRunsOnceRoundFromThePole) {
  const Case c(GeneratedSurface("hemisphere", 500));
  const auto& [core, pole, rest, lengths, targets, chain, loop, arc] = c.disk;
  EXPECT_EQ(loop.size(), BoundaryLoops(c.surface.triangulation).front().size());
  EXPECT_EQ(loop[0], c.pole);
  EXPECT_EQ(arc[0], 0);
  EXPECT_TRUE(std::is_sorted(arc.begin(), arc.end()));
  EXPECT_LT(arc.back(), 1);
  EXPECT_GT(arc.back(), 0.9);
  // The chain is what the loop is without the pole, and where angles are asked to be straight.
  ASSERT_EQ(chain.size(), loop.size() - 1);
  for (std::size_t k = 0; k < chain.size(); ++k) EXPECT_EQ(rest.vertex[chain[k]], loop[k + 1]);
  for (std::size_t k = 1; k + 1 < chain.size(); ++k) {
    EXPECT_EQ(targets.lower[chain[k]], kPi);
    EXPECT_EQ(targets.upper[chain[k]], kPi);
  }
  EXPECT_EQ(targets.upper[chain.front()], 0.5 * (kPi - kEpsilon));
  EXPECT_EQ(targets.lower[chain.back()], 0);
}

TEST(TakeOffStar, InnerVerticesStayFlatAndTheLinkConvex) {
  const Case c(GeneratedSurface("bumpy_terrain", 300));
  const Triangulation& t = c.disk.rest.triangulation;
  const std::vector<bool> boundary = BoundaryVertices(t);
  int on_link = 0;
  for (Index v = 0; v < t.num_vertices; ++v) {
    const auto& chain = c.disk.chain;
    if (!boundary[v]) {
      EXPECT_EQ(c.disk.targets.lower[v], 2 * kPi);
      EXPECT_EQ(c.disk.targets.upper[v], 2 * kPi);
    } else if (std::find(chain.begin(), chain.end(), v) == chain.end()) {
      ++on_link;
      EXPECT_EQ(c.disk.targets.lower[v], 0);
      EXPECT_LE(c.disk.targets.upper[v], kPi);
    }
  }
  EXPECT_GT(on_link, 0);
}

TEST(KeepStar, TurnsAlongTheLinkByPiInAll) {
  for (const char* name : {"bumpy_terrain", "hemisphere", "spherical_cap"}) {
    SCOPED_TRACE(name);
    Case c(GeneratedSurface(name, 300));
    const ConeTargets before = c.disk.targets;
    KeepStar(c.surface.triangulation, c.measured.angles, kEpsilon, &c.disk);
    const auto& chain = c.disk.chain;
    double turned = 0;
    const std::vector<bool> boundary = BoundaryVertices(c.disk.rest.triangulation);
    for (Index v = 0; v < c.disk.rest.triangulation.num_vertices; ++v) {
      const bool inside_chain = std::find(chain.begin() + 1, chain.end() - 1, v) != chain.end() - 1;
      if (!boundary[v] || inside_chain) {
        EXPECT_EQ(c.disk.targets.lower[v], before.lower[v]);
        continue;
      }
      EXPECT_TRUE(c.disk.targets.IsFixed(v));
      const bool is_end = v == chain.front() || v == chain.back();
      turned += (is_end ? 0.5 * kPi : kPi) - c.disk.targets.lower[v];
    }
    // With the pole at infinity the boundary is a straight line that comes back from the other
    // side.
    EXPECT_NEAR(turned, kPi, 1e-9);
  }
}

TEST(NumberAsInFile, OfADiskNamesThePoleAndTheWholeSurface) {
  const Case c(GeneratedSurface("hemisphere", 100));
  InfeasibilityCertificate proof;
  const Index rest = c.disk.rest.triangulation.num_faces();
  proof.face_multiplier.assign(rest, 1);
  proof.carrying_faces = {0, rest - 1};
  proof.constrained_vertex = {0};
  NumberAsInFile(c.surface, c.disk, &proof);
  EXPECT_EQ(proof.removed_vertex, c.surface.soup_vertex[c.pole]);
  ASSERT_EQ(static_cast<Index>(proof.face_multiplier.size()), c.surface.triangulation.num_faces());
  for (Index h = 0; h < c.surface.triangulation.num_halfedges(); ++h) {
    if (c.surface.triangulation.vertex[h] == c.pole) {
      EXPECT_EQ(proof.face_multiplier[h / 3], 0);
    }
  }
  EXPECT_EQ(std::accumulate(proof.face_multiplier.begin(), proof.face_multiplier.end(), 0.), rest);
  EXPECT_EQ(proof.constrained_vertex[0], c.surface.soup_vertex[c.disk.rest.vertex[0]]);
}

/// The half-plane in which a strip lies: its lower side on the real axis.
HalfPlaneChart SomeChart(const Case& c) {
  HalfPlaneChart chart;
  chart.disk = c.disk;
  // A disk automorphism's inverse of a round disk: vertex positions of a flat fan, moved by Cayley.
  chart.position.assign(c.surface.triangulation.num_vertices, Complex(0, 0));
  const Complex pole = {c.surface.position[c.pole].x(), c.surface.position[c.pole].y()};
  for (Index v = 0; v < c.surface.triangulation.num_vertices; ++v) {
    if (v == c.pole) continue;
    const Complex w = Complex(c.surface.position[v].x(), c.surface.position[v].y()) / pole;
    const Complex z = Complex(0, 1) * (1. + w) / (1. - w);
    chart.position[v] = {z.real(), c.measured.boundary[v] ? 0 : z.imag()};
  }
  return chart;
}

TEST(DiskPlacement, PutsAFlatFanBackWhereItWas) {
  // A flat fan is a disk whose boundary lies on a circle: its own map to the disk.
  const Case c(Fan(8, 0), 3);
  DomainOptions options;
  options.centre = kNone;
  for (Index v = 0; v < c.surface.triangulation.num_vertices; ++v) {
    if (!c.measured.boundary[v]) options.centre = v;
  }
  options.angle_zero = c.pole;
  DiskPlacement placement(c.surface, c.measured, options, {});
  EXPECT_TRUE(placement.Place(SomeChart(c)).empty());
  const Complex pole = {c.surface.position[c.pole].x(), c.surface.position[c.pole].y()};
  for (Index v = 0; v < c.surface.triangulation.num_vertices; ++v) {
    const Complex own = Complex(c.surface.position[v].x(), c.surface.position[v].y()) / pole;
    EXPECT_LT(std::abs(placement.position()[v] - own), 1e-12) << v;
  }
  EXPECT_EQ(placement.position()[options.centre], Complex(0));
  EXPECT_LT(placement.BoundaryCentreOfMass(), 1e-12);
  EXPECT_LT(placement.AreaCentreOfMass(), 1e-12);
  EXPECT_TRUE(FlippedFaces(c.surface.triangulation, placement.Uv()).empty());
}

TEST(PutsMassAtCentre, OnlyWhereANormalizationIsNamed) {
  EXPECT_FALSE(PutsMassAtCentre({}));
  EXPECT_FALSE(PutsMassAtCentre({.normalization = "none"}));
  EXPECT_TRUE(PutsMassAtCentre({.normalization = "area"}));
}

}  // namespace
}  // namespace cirque

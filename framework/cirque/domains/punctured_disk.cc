#include "cirque/domains/punctured_disk.h"

#include <algorithm>
#include <utility>

namespace cirque {
namespace {

/// The boundary loop of the surface from the vertex `first` on, with arc lengths.
void FollowBoundary(const Triangulation& t, const EdgeLengths& lengths, PuncturedDisk* disk) {
  std::vector<Index> loop = BoundaryLoops(t).front();
  const auto at_pole = [&](Index h) { return t.Tail(h) == disk->pole; };
  std::rotate(loop.begin(), std::find_if(loop.begin(), loop.end(), at_pole), loop.end());
  double total = 0;
  for (const Index h : loop) {
    disk->loop.push_back(t.Tail(h));
    disk->arc.push_back(total);
    total += lengths.value[t.edge[h]];
  }
  for (double& share : disk->arc) share /= total;
}

/// The vertices along the boundary of the rest that is no link of the pole.
std::vector<Index> StraightChain(const Triangulation& whole, const PuncturedDisk& disk) {
  const Triangulation& t = disk.rest.triangulation;
  std::vector<Index> loop = BoundaryLoops(t).front();
  const auto in_link = [&](Index h) {
    const Index g = whole.twin[disk.rest.Halfedge(h)];
    return g != kNone && disk.core[Triangulation::Face(g)];
  };
  const auto link = std::find_if(loop.begin(), loop.end(), in_link);
  std::rotate(loop.begin(), link, loop.end());
  std::vector<Index> chain;
  for (const Index h : loop) {
    if (in_link(h)) continue;
    if (chain.empty()) chain.push_back(t.Tail(h));
    chain.push_back(t.Tip(h));
  }
  return chain;
}

/// Straight but for the ends of the chain; convex along the link, which is the rest of the
/// boundary.
ConeTargets StraightTargets(const PuncturedDisk& disk, double epsilon) {
  const Triangulation& t = disk.rest.triangulation;
  ConeTargets targets = FreeBoundaryTargets(t);
  for (Index v = 0; v < t.num_vertices; ++v) {
    const bool is_free = targets.lower[v] == 0, has_one_corner = targets.upper[v] == kPi;
    if (is_free && !has_one_corner) targets.upper[v] = kPi - epsilon;
  }
  for (const Index v : disk.chain) targets.lower[v] = targets.upper[v] = kPi;
  for (const Index v : {disk.chain.front(), disk.chain.back()}) {
    targets.lower[v] = 0;
    targets.upper[v] = 0.5 * (kPi - epsilon);
  }
  return targets;
}

}  // namespace

PuncturedDisk TakeOffStar(const Triangulation& t, const EdgeLengths& lengths,
                          const std::vector<bool>& core, Index pole, double epsilon) {
  PuncturedDisk disk;
  disk.core = core;
  disk.pole = pole;
  FollowBoundary(t, lengths, &disk);
  std::vector<bool> keep = core;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (t.vertex[h] == pole) keep[Triangulation::Face(h)] = false;
  }
  disk.rest = KeepFaces(t, keep);
  if (disk.rest.face.empty()) return disk;
  disk.lengths = LengthsOf(disk.rest, t, lengths);
  disk.chain = StraightChain(t, disk);
  disk.targets = StraightTargets(disk, epsilon);
  return disk;
}

void KeepStar(const Triangulation& whole, const CornerAngles& angles, double epsilon,
              PuncturedDisk* disk) {
  constexpr double kLeast = 0.05;  // [rad] left for the angle sum of a link vertex
  const SubTriangulation& rest = disk->rest;
  double around_pole = 0;
  const auto for_each_star_corner = [&](const auto& visit) {
    for (Index h = 0; h < whole.num_halfedges(); ++h) {
      if (whole.vertex[h] == disk->pole && disk->core[Triangulation::Face(h)]) visit(h);
    }
  };
  for_each_star_corner([&](Index h) { around_pole += angles.value[h]; });
  std::vector<double> opposite(rest.triangulation.num_vertices, -1);  // of the edge to the pole
  for_each_star_corner([&](Index h) {
    const Index next = Triangulation::Next(h), prev = Triangulation::Prev(h);
    const double surplus = 0.5 * angles.value[h] * (1 - kPi / around_pole);
    for (const auto& [corner, other] : {std::pair(next, prev), std::pair(prev, next)}) {
      double& sum = opposite[rest.of_vertex[whole.vertex[other]]];
      sum = std::max(sum, 0.0) + angles.value[corner] + surplus;
    }
  });
  const auto straight = [&](Index v) {
    return v == disk->chain.front() || v == disk->chain.back() ? 0.5 * kPi : kPi;
  };
  double turned = 0;
  for (Index v = 0; v < rest.triangulation.num_vertices; ++v) {
    if (opposite[v] < 0) continue;
    const double full = straight(v);
    opposite[v] = std::clamp(full - opposite[v], epsilon * full / kPi, full - kLeast);
    turned += opposite[v];
  }
  for (Index v = 0; v < rest.triangulation.num_vertices; ++v) {
    if (opposite[v] < 0) continue;
    disk->targets.lower[v] = disk->targets.upper[v] = straight(v) - opposite[v] * kPi / turned;
  }
}

void NumberAsInFile(const Surface& surface, const PuncturedDisk& disk,
                    InfeasibilityCertificate* proof) {
  const SubTriangulation& rest = disk.rest;
  std::vector<double> of_face(surface.triangulation.num_faces(), 0);
  for (std::size_t f = 0; f < rest.face.size(); ++f) {
    of_face[rest.face[f]] = proof->face_multiplier[f];
  }
  proof->face_multiplier = std::move(of_face);
  for (Index& f : proof->carrying_faces) f = rest.face[f];
  for (auto* vertices : {&proof->constrained_vertex, &proof->carrying_vertices}) {
    for (Index& v : *vertices) v = surface.soup_vertex[rest.vertex[v]];
  }
  proof->removed_vertex = surface.soup_vertex[disk.pole];
}

}  // namespace cirque

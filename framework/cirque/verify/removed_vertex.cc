#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cirque/verify/infeasibility_check.h"

namespace cirque::verify {
namespace {

Index NumHalfedges(const TriangleMesh& mesh) { return static_cast<Index>(mesh.vertex.size()); }

std::vector<bool> BoundaryOf(const Surface& surface) {
  std::vector<bool> on_boundary(surface.mesh.num_vertices, false);
  for (Index h = 0; h < NumHalfedges(surface.mesh); ++h) {
    if (surface.twin[h] != kNone) continue;
    on_boundary[surface.mesh.Tail(h)] = on_boundary[surface.mesh.Tip(h)] = true;
  }
  return on_boundary;
}

/// The largest part into which the inner edges between boundary vertices cut the surface, the one
/// with the first triangle among equals; of a closed surface all of it.
std::vector<bool> LargestPiece(const Surface& surface) {
  const TriangleMesh& mesh = surface.mesh;
  const std::vector<bool> on_boundary = BoundaryOf(surface);
  std::vector<Index> piece(mesh.num_triangles(), kNone), size;
  for (Index first = 0; first < mesh.num_triangles(); ++first) {
    if (piece[first] != kNone) continue;
    const auto label = static_cast<Index>(size.size());
    size.push_back(0);
    std::vector<Index> pending = {first};
    piece[first] = label;
    while (!pending.empty()) {
      const Index f = pending.back();
      pending.pop_back();
      ++size[label];
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index t = surface.twin[h];
        const bool chord = on_boundary[mesh.Tail(h)] && on_boundary[mesh.Tip(h)];
        if (t == kNone || chord || piece[t / 3] != kNone) continue;
        piece[t / 3] = label;
        pending.push_back(t / 3);
      }
    }
  }
  const auto largest =
      static_cast<Index>(std::max_element(size.begin(), size.end()) - size.begin());
  std::vector<bool> in_largest;
  for (const Index label : piece) in_largest.push_back(label == largest);
  return in_largest;
}

/// The surface and the certificate without some triangles, whose multipliers must be 0.
bool KeepTriangles(const std::vector<bool>& keep, const std::string& what, Surface* surface,
                   InfeasibilityCertificate* certificate, InfeasibilityReport* report) {
  TriangleMesh rest;
  rest.num_vertices = surface->mesh.num_vertices;
  std::vector<double> multiplier;
  for (Index f = 0; f < surface->mesh.num_triangles(); ++f) {
    if (keep[f]) {
      const auto corner = surface->mesh.vertex.begin() + 3 * f;
      rest.vertex.insert(rest.vertex.end(), corner, corner + 3);
      const auto inside = surface->mesh.diagonal.begin() + 3 * f;
      rest.diagonal.insert(rest.diagonal.end(), inside, inside + 3);
      const auto place = surface->mesh.place.begin() + 3 * f;
      rest.place.insert(rest.place.end(), place, place + 3);
      rest.face.push_back(surface->mesh.face[f]);
      multiplier.push_back(certificate->face_multiplier[f]);
    } else if (certificate->face_multiplier[f] != 0) {
      report->errors.push_back(
          fmt::format("triangle {} {} has a multiplier that is not 0", f, what));
    }
  }
  if (!report->accepted()) return false;
  StatusOr<std::vector<Index>> twin = PairHalfedges(rest);
  surface->mesh = std::move(rest);
  surface->twin = *std::move(twin);
  certificate->face_multiplier = std::move(multiplier);
  return true;
}

/// What the vertices of a boundary are to be: of the link of the removed vertex (its ends are those
/// that were on the boundary before) or not.
struct Boundary {
  std::vector<bool> before, after, on_link;
};

/// The link may be held to convexity, so from above only; how tightly is part of the verdict. Its
/// ends stand for both sides of a mirror. The rest of a boundary must be straight.
void CheckBoundary(const InfeasibilityCertificate& certificate, const Boundary& boundary,
                   InfeasibilityReport* report) {
  for (std::size_t i = 0; i < certificate.constrained_vertex.size(); ++i) {
    const Index v = certificate.constrained_vertex[i];
    const double lower = certificate.lower_over_pi[i], upper = certificate.upper_over_pi[i];
    if (boundary.on_link[v]) {
      const double both_sides = boundary.before[v] ? 2 * upper : upper;
      report->link_upper_over_pi = std::min(report->link_upper_over_pi, both_sides);
      if (lower <= 0) continue;
      return report->errors.push_back(
          fmt::format("vertex {}, next to the removed one, is held to at least {} pi", v, lower));
    }
    if (!boundary.after[v] || (lower == 1 && upper == 1)) continue;
    return report->errors.push_back(fmt::format(
        "vertex {} on the boundary is held to [{}, {}] pi instead of pi", v, lower, upper));
  }
}

}  // namespace

bool RemoveVertex(Surface* surface, InfeasibilityCertificate* certificate,
                  InfeasibilityReport* report) {
  const Index removed = certificate->removed_vertex;
  if (removed < 0 || removed >= surface->mesh.num_vertices) {
    report->errors.push_back(fmt::format("removed_vertex = {} does not exist; there are {}",
                                         removed, surface->mesh.num_vertices));
    return false;
  }
  const std::vector<bool> piece = LargestPiece(*surface);
  report->num_beyond_chords = static_cast<Index>(std::count(piece.begin(), piece.end(), false));
  if (!KeepTriangles(piece, "beyond an edge between two boundary vertices", surface, certificate,
                     report))
    return false;
  Boundary boundary;
  boundary.before = BoundaryOf(*surface);
  boundary.on_link.assign(surface->mesh.num_vertices, false);
  report->straight_boundary =
      std::find(boundary.before.begin(), boundary.before.end(), true) != boundary.before.end();
  if (report->straight_boundary && !boundary.before[removed]) {
    report->errors.push_back(fmt::format(
        "removed_vertex = {} is no boundary vertex of a mesh that is not closed", removed));
    return false;
  }
  std::vector<bool> keep;
  for (Index h = 0; h < NumHalfedges(surface->mesh); h += 3) {
    const auto corners = {surface->mesh.vertex[h], surface->mesh.vertex[h + 1],
                          surface->mesh.vertex[h + 2]};
    keep.push_back(std::find(corners.begin(), corners.end(), removed) == corners.end());
    if (keep.back()) continue;
    for (const Index v : corners) boundary.on_link[v] = true;
  }
  if (!KeepTriangles(keep, "at the removed vertex", surface, certificate, report)) return false;
  boundary.after = BoundaryOf(*surface);
  CheckBoundary(*certificate, boundary, report);
  return report->accepted();
}

}  // namespace cirque::verify

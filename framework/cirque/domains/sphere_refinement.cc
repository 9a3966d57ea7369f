#include "cirque/domains/sphere_refinement.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/mesh/holes.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/metrics/mapped_faces.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

constexpr double kReach = 1.5;  ///< of a cap; 1 is the hemisphere

/// Makes the faces with `keep` a surface: where they would leave a vertex with several fans of
/// corners, all of its faces go.
void RemovePinches(const Triangulation& t, std::vector<bool>* keep) {
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<int> fans(t.num_vertices, 0);
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      if (!(*keep)[Triangulation::Face(h)]) continue;
      const Index twin = t.twin[h];
      const bool ends = twin == kNone || !(*keep)[Triangulation::Face(twin)];
      fans[t.Tail(h)] += ends ? 1 : 0;
    }
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      if (fans[t.vertex[h]] < 2 || !(*keep)[Triangulation::Face(h)]) continue;
      (*keep)[Triangulation::Face(h)] = false;
      changed = true;
    }
  }
}

/// A map to the sphere by the chart's coordinates w, infinite at the pole.
class SphereMapRefiner {
 public:
  SphereMapRefiner(const Triangulation& t, const EdgeLengths& lengths, const SphereChart& chart,
                   const PlaneWithPole& plane)
      : t_(t), lengths_(lengths), chart_(chart), pole_(plane.pole), w_(t.num_vertices) {
    for (Index v = 0; v < t.num_vertices; ++v) {
      const Eigen::Vector2d w = (plane.position[v] - chart.centre) / chart.scale;
      w_[v] = {w.x(), w.y()};
    }
  }

  /// Of the cap about the centre, or about infinity, in the coordinate 1 / w.
  Status RefineCap(bool about_infinity, const std::string& refine_map,
                   const std::atomic<bool>* cancelled,
                   std::optional<MapRefinementSummary>* summary) {
    std::vector<Complex> place(t_.num_vertices);
    for (Index v = 0; v < t_.num_vertices; ++v) {
      place[v] = about_infinity ? (v == pole_ ? 0 : 1.0 / w_[v]) : w_[v];
    }
    const SubTriangulation cap = KeepFaces(t_, FacesWithin(place, about_infinity));
    if (cap.face.empty()) return Status();
    const EdgeLengths lengths = LengthsOf(cap, t_, lengths_);
    const IntrinsicSurface surface = MeasureSurface(cap.triangulation, lengths);
    std::vector<bool> held = surface.boundary;
    if (about_infinity && cap.of_vertex[pole_] != kNone) held[cap.of_vertex[pole_]] = true;
    CornerUv uv;
    for (const Index v : cap.triangulation.vertex) {
      uv.value.emplace_back(place[cap.vertex[v]].real(), place[cap.vertex[v]].imag());
    }
    if (!FlippedFaces(cap.triangulation, uv).empty()) return Status();
    Status status = RefineHeldMap(surface, {held}, refine_map, cancelled, &uv, summary);
    if (!status.ok()) return status;
    for (Index h = 0; h < cap.triangulation.num_halfedges(); ++h) {
      const Index v = cap.triangulation.vertex[h];
      if (held[v]) continue;
      const Complex moved(uv.value[h].x(), uv.value[h].y());
      w_[cap.vertex[v]] = about_infinity ? 1.0 / moved : moved;
    }
    return Status();
  }

  PlaneWithPole Plane() const {
    PlaneWithPole plane{pole_, {}};
    for (const Complex w : w_) {
      plane.position.push_back(chart_.centre + chart_.scale * Eigen::Vector2d(w.real(), w.imag()));
    }
    return plane;
  }

 private:
  std::vector<bool> FacesWithin(const std::vector<Complex>& place, bool about_infinity) const {
    std::vector<bool> keep(t_.num_faces(), true);
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      const Index v = t_.vertex[h];
      const bool inside = std::abs(place[v]) <= kReach && (v != pole_ || about_infinity);
      if (!inside) keep[Triangulation::Face(h)] = false;
    }
    RemovePinches(t_, &keep);
    return keep;
  }

  const Triangulation& t_;
  const EdgeLengths& lengths_;
  const SphereChart chart_;
  const Index pole_;
  std::vector<Complex> w_;
};

/// The mean of q + 1/q - 2 on the sphere's chords, on which no triangle is flipped.
double MeanEnergy(const Triangulation& t, const EdgeLengths& lengths, const SphereChart& chart,
                  const PlaneWithPole& plane) {
  const std::vector<Eigen::Vector3d> position = LiftAll(plane, chart);
  const EdgeLengths chords = ChordLengths(t, position);
  const MappedFaces faces = MeasureFaces(t, lengths, FacesInPlane(MeasureSurface(t, chords)));
  const Eigen::ArrayXd q = faces.sigma_max.array() / faces.sigma_min.array();
  return faces.area.dot((q + q.inverse() - 2).matrix()) / faces.area.sum();
}

/// Adds what a cap took.
void Add(const std::optional<MapRefinementSummary>& cap, MapRefinementSummary* both) {
  if (!cap) return;
  both->map_refinement_steps += cap->map_refinement_steps;
  if (cap->map_refinement_at_rest) {
    both->map_refinement_at_rest =
        std::min(both->map_refinement_at_rest.value_or(1), *cap->map_refinement_at_rest);
  }
  for (const auto member :
       {&MapRefinementSummary::map_refinement_flagged,
        &MapRefinementSummary::map_refinement_patches, &MapRefinementSummary::map_refinement_rounds,
        &MapRefinementSummary::map_refinement_patch_steps}) {
    const std::optional<int>& part = (*cap).*member;
    std::optional<int>& sum = both->*member;
    if (part) sum = sum.value_or(0) + *part;
  }
}

constexpr int kPutBackRounds = 10;

}  // namespace

bool PutBackFlipped(const Triangulation& t, const SphereChart& chart, const PlaneWithPole& before,
                    PlaneWithPole* refined) {
  std::vector<bool> back(t.num_vertices, false);
  for (int round = 0;; ++round) {
    const std::vector<Index> flipped = FlippedSphericalFaces(t, LiftAll(*refined, chart));
    if (flipped.empty() || round == kPutBackRounds) return flipped.empty();
    std::vector<bool> wider = back;
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      if (back[t.vertex[h]]) wider[t.Tail(h)] = true;
    }
    for (const Index f : flipped) {
      for (Index h = 3 * f; h < 3 * f + 3; ++h) wider[t.vertex[h]] = true;
    }
    back = std::move(wider);
    for (Index v = 0; v < t.num_vertices; ++v) {
      if (back[v]) refined->position[v] = before.position[v];
    }
  }
}

Status RefineOnSphere(const Triangulation& t, const EdgeLengths& lengths, const SphereChart& chart,
                      const std::string& refine_map, const std::atomic<bool>* cancelled,
                      PlaneWithPole* plane, std::optional<MapRefinementSummary>* summary) {
  SphereMapRefiner refiner(t, lengths, chart, *plane);
  std::optional<MapRefinementSummary> centre, infinity;
  if (Status s = refiner.RefineCap(false, refine_map, cancelled, &centre); !s.ok()) return s;
  if (Status s = refiner.RefineCap(true, refine_map, cancelled, &infinity); !s.ok()) return s;
  PlaneWithPole refined = refiner.Plane();
  const bool holds = PutBackFlipped(t, chart, *plane, &refined);
  MapRefinementSummary both;
  Add(centre, &both);
  Add(infinity, &both);
  both.map_refinement_before = both.map_refinement_after = MeanEnergy(t, lengths, chart, *plane);
  const double energy = holds ? MeanEnergy(t, lengths, chart, refined) : both.map_refinement_before;
  if (energy < both.map_refinement_before) {
    both.map_refinement_after = energy;
    *plane = std::move(refined);
  }
  *summary = both;
  return Status();
}

}  // namespace cirque

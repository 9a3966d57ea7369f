#include "cirque/pipeline/repair_cones.h"

#include <algorithm>
#include <vector>

namespace cirque {
namespace {

constexpr double kSpareCorner = 0.5, kLeastAngle = kPi / 4;

class Repair {
 public:
  Repair(const IntrinsicSurface& surface, const ConeTargets& targets,
         const InfeasibilityCertificate& proof)
      : t_(surface.triangulation),
        corners_(surface.corners),
        boundary_(surface.boundary),
        pointed_at_(surface.triangulation.num_vertices, false) {
    const Triangulation& t = t_;
    repair_.targets = targets;
    std::vector<bool> carries(t.num_vertices, false);
    for (const Index v : proof.carrying_vertices) carries[v] = true;
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      for (const Index v : {t.vertex[h], t.Tail(h), t.Tip(h)}) {
        if (carries[v] && IsCone(t.vertex[h])) pointed_at_[t.vertex[h]] = true;
      }
    }
    if (std::find(pointed_at_.begin(), pointed_at_.end(), true) != pointed_at_.end()) return;
    for (Index v = 0; v < t.num_vertices; ++v) pointed_at_[v] = IsCone(v);
  }

  ConeRepair Run(int round) {
    for (Index v = 0; v < t_.num_vertices; ++v) {
      if (round == 1 && pointed_at_[v]) Move(v);
      if (round > 1 && IsCone(v)) Widen(v, (round - 1) * kPi / (pointed_at_[v] ? 4 : 16));
    }
    return repair_;
  }

 private:
  bool IsCone(Index v) const {
    const ConeTargets& targets = repair_.targets;
    return !boundary_[v] && !(targets.lower[v] == 2 * kPi && targets.upper[v] == 2 * kPi);
  }

  void Move(Index v) {
    Index best = v;
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      if (t_.Tail(h) != v) continue;
      const Index w = t_.Tip(h);
      if (!boundary_[w] && !IsCone(w) && corners_[w] > corners_[best]) best = w;
    }
    if (best == v) return;
    std::swap(repair_.targets.lower[v], repair_.targets.lower[best]);
    std::swap(repair_.targets.upper[v], repair_.targets.upper[best]);
    ++repair_.moved;
  }

  void Widen(Index v, double width) {
    double& lower = repair_.targets.lower[v];
    double& upper = repair_.targets.upper[v];
    const double greatest = kPi * (corners_[v] - kSpareCorner);
    lower = std::min(lower, std::max(kLeastAngle, lower - width));
    upper = std::max(upper, std::min(greatest, upper + width));
    if (pointed_at_[v]) ++repair_.widened;
  }

  const Triangulation& t_;
  const std::vector<Index>& corners_;
  const std::vector<bool>& boundary_;
  std::vector<bool> pointed_at_;
  ConeRepair repair_;
};

}  // namespace

ConeRepair RepairCones(const IntrinsicSurface& surface, const ConeTargets& targets,
                       const InfeasibilityCertificate& proof, int round) {
  return Repair(surface, targets, proof).Run(round);
}

}  // namespace cirque

#include "cirque/layout/landmarks.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "cirque/layout/gauss_newton.h"
#include "cirque/layout/packing.h"
#include "cirque/layout/stretch_sum.h"
#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

constexpr double kFirstWeight = 1, kLastWeight = 1e8, kFactor = 100;

Complex ToComplex(const Eigen::Vector2d& p) { return {p.x(), p.y()}; }

class LandmarkDescent {
 public:
  LandmarkDescent(const SeamedSurface& of, const StretchEnergy& energy,
                  const RefineStretchOptions& options, const std::vector<Landmark>& landmarks,
                  const std::atomic<bool>* cancelled, CornerUv* uv)
      : of_(of),
        energy_(energy),
        options_(options),
        landmarks_(landmarks),
        cancelled_(cancelled),
        uv_(uv),
        area_(AreaOf(*uv)),
        map_(of, *uv, 0),
        unit_(BestUnit(map_.faces(), energy, map_.z())) {
    const Triangulation& t = of.surface.triangulation;
    std::vector<Index> opened(t.num_vertices);
    for (Index h = 0; h < t.num_halfedges(); ++h) opened[t.vertex[h]] = map_.open().vertex[h];
    for (const Landmark& landmark : landmarks) opened_.push_back(opened[landmark.vertex]);
    fit_.miss_before = Miss();
    fit_.energy_before = Energy();
  }

  LandmarkFit Soft(double weight) {
    Draw(weight);
    map_.WriteTo(uv_);
    return Finish();
  }

  LandmarkFit Hard() {
    for (double weight = kFirstWeight; weight <= kLastWeight && !IsCancelled(); weight *= kFactor) {
      Draw(weight);
      map_.WriteTo(uv_);
      if (!PutInPlace()) continue;
      LowerWhereTheyAre();
      fit_.exact = true;
      break;
    }
    return Finish();
  }

 private:
  bool IsCancelled() const { return cancelled_ && *cancelled_; }

  double Miss() const {
    double miss = 0;
    for (std::size_t k = 0; k < opened_.size(); ++k) {
      miss = std::max(miss, std::abs(map_.z()[opened_[k]] - ToComplex(landmarks_[k].at)));
    }
    return miss / std::sqrt(area_);
  }

  double Energy() const { return StretchOf(map_.faces(), energy_, unit_, map_.z()); }

  LandmarkFit Finish() {
    fit_.miss_after = Miss();
    fit_.energy_after = Energy();
    return fit_;
  }

  void Draw(double weight) {
    MapPart part = map_.Whole();
    std::vector<Index> number(map_.z().size(), kNone);
    for (Index i = 0; i < part.unknowns; ++i) number[part.vertex[i]] = i;
    const double each = weight / (area_ * static_cast<double>(landmarks_.size()));
    for (std::size_t k = 0; k < opened_.size(); ++k) {
      if (number[opened_[k]] == kNone) continue;
      part.pulls.push_back({number[opened_[k]], ToComplex(landmarks_[k].at), each});
    }
    Lower(part);
  }

  void Lower(const MapPart& part) {
    fit_.steps += LowerStretch(part, energy_, unit_, {options_.steps, options_.decrease},
                               cancelled_, &map_.z());
  }

  /// Straight to their places, if that flips nothing.
  bool PutInPlace() {
    CornerUv moved = *uv_;
    const Triangulation& t = of_.surface.triangulation;
    std::vector<Index> landmark(t.num_vertices, kNone);
    for (std::size_t k = 0; k < landmarks_.size(); ++k) {
      landmark[landmarks_[k].vertex] = static_cast<Index>(k);
    }
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      const Index k = landmark[t.vertex[h]];
      if (k != kNone) moved.value[h] = landmarks_[k].at;
    }
    for (std::size_t c = 0; c < moved.value.size(); c += 3) {
      const bool kept = OrientationSign(moved.value[c], moved.value[c + 1], moved.value[c + 2]) > 0;
      if (!kept) return false;
    }
    *uv_ = std::move(moved);
    return true;
  }

  void LowerWhereTheyAre() {
    SeamedSurface held = of_;
    held.held.resize(of_.surface.triangulation.num_vertices, false);
    for (const Landmark& landmark : landmarks_) held.held[landmark.vertex] = true;
    map_ = OpenedMap(held, *uv_, 0);
    Lower(map_.Whole());
    map_.WriteTo(uv_);
  }

  const SeamedSurface& of_;
  const StretchEnergy& energy_;
  const RefineStretchOptions& options_;
  const std::vector<Landmark>& landmarks_;
  const std::atomic<bool>* cancelled_;
  CornerUv* uv_;
  double area_;
  mutable OpenedMap map_;
  double unit_;
  std::vector<Index> opened_;  ///< the landmarks' vertices of the opened surface
  LandmarkFit fit_;
};

}  // namespace

StatusOr<LandmarkFit> MeetLandmarks(const SeamedSurface& of, StretchEnergy energy,
                                    const RefineStretchOptions& options,
                                    const std::vector<Landmark>& landmarks, double weight,
                                    const std::atomic<bool>* cancelled, CornerUv* uv) {
  if (energy.blends) energy.weight = options.weight;
  SeamedSurface placed = of;
  placed.has_place = true;
  LandmarkDescent descent(placed, energy, options, landmarks, cancelled, uv);
  const LandmarkFit fit = weight > 0 ? descent.Soft(weight) : descent.Hard();
  if (cancelled && *cancelled) return Status(StatusCode::kCancelled, "landmarks: interrupted");
  return fit;
}

}  // namespace cirque

#include "cirque/metrics/mapped_faces.h"

#include <algorithm>
#include <cmath>

#include <glog/logging.h>

#include "cirque/core/parallel.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/math/arctangent.h"
#include "cirque/math/elementary.h"
#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Eigen::Vector2d;

struct FaceMeasure {
  double area = 0, image_area = 0, sigma_max = 0, sigma_min = 0;
  Eigen::Vector3d angle, image_angle;
  bool flipped = false;

  bool IsMeasurable() const {
    return area > 0 && image_area > 0 && sigma_min > 0 && std::isfinite(sigma_max / sigma_min) &&
           std::isfinite(image_area);
  }
};

/// a x b with one rounding (Kahan).
double Cross(const Vector2d& a, const Vector2d& b) {
  const double product = a.y() * b.x();
  const double error = std::fma(-a.y(), b.x(), product);
  return std::fma(a.x(), b.y(), -product) + error;
}

/// A power of two near the largest, so that scaling by it is exact; 1 where there is none.
double UnitNear(double largest) {
  return largest > 0 && std::isfinite(largest) ? std::ldexp(1.0, std::ilogb(largest)) : 1;
}

double LongestImageEdge(const CornerUv& uv) {
  double longest = 0;
  for (std::size_t h = 0; h < uv.value.size(); ++h) {
    const Vector2d edge = uv.value[h] - uv.value[h - h % 3];
    if (edge.allFinite()) longest = std::max(longest, edge.lpNorm<Eigen::Infinity>());
  }
  return longest;
}

/// The singular values of the map that takes the triangle with sides b and c about its corner angle, of
/// at most pi / 3, to image edges p (of side c) and q: half the sum and the difference of the moduli of
/// twice the conformal and the anticonformal part of its differential, the difference by the
/// determinant.
void MeasureSingularValues(double b, double c, double angle, const Vector2d& p, const Vector2d& q,
                           FaceMeasure* m) {
  const double sine = SineToPi(angle), cosine = std::sqrt((1 - sine) * (1 + sine));
  const Vector2d x = p / c, y = (q / b - cosine * x) / sine;
  m->area = b * c * sine / 2;
  m->image_area = std::abs(Cross(p, q)) / 2;
  const double conformal = std::hypot(x.x() + y.y(), x.y() - y.x());
  const double anticonformal = std::hypot(x.x() - y.y(), x.y() + y.x());
  m->sigma_max = (conformal + anticonformal) / 2;
  m->sigma_min = m->image_area / (m->area * m->sigma_max);
}

class FaceMeter {
 public:
  FaceMeter(const MappedFaces& faces, const CornerAngles* angles)
      : t_(faces.triangulation),
        lengths_(faces.lengths),
        uv_(faces.uv),
        own_(angles ? CornerAngles() : MeasureCornerAngles(t_, lengths_)),
        angles_(angles ? *angles : own_),
        length_unit_(UnitNear(lengths_.value.size() > 0 ? lengths_.value.maxCoeff() : 0)),
        image_unit_(UnitNear(LongestImageEdge(uv_))) {}

  FaceMeasure Measure(Index f) const {
    FaceMeasure m;
    for (Index k = 0; k < 3; ++k) {
      const Vector2d p = ImageEdge(3 * f + k, Triangulation::Next(3 * f + k));
      const Vector2d q = ImageEdge(3 * f + k, Triangulation::Prev(3 * f + k));
      if (!p.allFinite() || !q.allFinite()) return {};
      m.angle[k] = angles_.value[3 * f + k];
      m.image_angle[k] = Arctangent(std::abs(Cross(p, q)), p.dot(q));
    }
    // Seen from its smallest angle, whose sine is accurate however thin the triangle is.
    Index k = 0;
    m.angle.minCoeff(&k);
    const Index h = 3 * f + k, next = Triangulation::Next(h), prev = Triangulation::Prev(h);
    MeasureSingularValues(Length(next), Length(prev), m.angle[k], ImageEdge(h, next),
                          ImageEdge(h, prev), &m);
    const int sign = OrientationSign(uv_.value[3 * f], uv_.value[3 * f + 1], uv_.value[3 * f + 2]);
    if (sign == 0) return {};
    m.flipped = sign < 0;
    return m;
  }

  double length_unit() const { return length_unit_; }
  double image_unit() const { return image_unit_; }

 private:
  double Length(Index h) const { return lengths_.value[t_.edge[h]] / length_unit_; }
  Vector2d ImageEdge(Index from, Index to) const {
    return (uv_.value[to] - uv_.value[from]) / image_unit_;
  }

  const Triangulation& t_;
  const EdgeLengths& lengths_;
  const CornerUv& uv_;
  const CornerAngles own_;
  const CornerAngles& angles_;
  const double length_unit_, image_unit_;
};

void Resize(Index size, MappedFaces* faces) {
  faces->area.conservativeResize(size);
  faces->image_area.conservativeResize(size);
  faces->sigma_max.conservativeResize(size);
  faces->sigma_min.conservativeResize(size);
  faces->angle.conservativeResize(3, size);
  faces->image_angle.conservativeResize(3, size);
}

void Put(const FaceMeasure& m, Index f, MappedFaces* faces) {
  faces->area[f] = m.area;
  faces->image_area[f] = m.image_area;
  faces->sigma_max[f] = m.sigma_max;
  faces->sigma_min[f] = m.sigma_min;
  faces->angle.col(f) = m.angle;
  faces->image_angle.col(f) = m.image_angle;
}

/// Moves what is known of face f to the end of the list, which is not beyond it.
void Append(Index f, bool flipped, MappedFaces* faces) {
  const Index i = faces->num_faces();
  faces->face.push_back(f);
  faces->flipped.push_back(flipped);
  faces->area[i] = faces->area[f];
  faces->image_area[i] = faces->image_area[f];
  faces->sigma_max[i] = faces->sigma_max[f];
  faces->sigma_min[i] = faces->sigma_min[f];
  faces->angle.col(i) = faces->angle.col(f);
  faces->image_angle.col(i) = faces->image_angle.col(f);
}

}  // namespace

MappedFaces MeasureFaces(const Triangulation& t, const EdgeLengths& lengths, const CornerUv& uv,
                         const CornerAngles* angles) {
  CHECK_EQ(static_cast<Index>(uv.value.size()), t.num_halfedges());
  MappedFaces faces{.triangulation = t, .lengths = lengths, .uv = uv};
  const FaceMeter meter(faces, angles);
  Resize(t.num_faces(), &faces);
  std::vector<char> measurable(t.num_faces()), flipped(t.num_faces());
  ParallelFor(t.num_faces(), [&](Index f) {
    const FaceMeasure measure = meter.Measure(f);
    measurable[f] = measure.IsMeasurable();
    flipped[f] = measure.flipped;
    Put(measure, f, &faces);
  });
  faces.face.reserve(t.num_faces());
  for (Index f = 0; f < t.num_faces(); ++f) {
    if (measurable[f]) Append(f, flipped[f], &faces);
  }
  Resize(faces.num_faces(), &faces);
  const double size = std::sqrt(faces.area.sum()), image_size = std::sqrt(faces.image_area.sum());
  if (faces.num_faces() == 0) return faces;
  faces.area /= size * size;
  faces.image_area /= image_size * image_size;
  faces.sigma_max *= size / image_size;
  faces.sigma_min *= size / image_size;
  faces.surface_size = size * meter.length_unit();
  faces.image_size = image_size * meter.image_unit();
  return faces;
}

EdgeLengths ChordLengths(const Triangulation& t, const std::vector<Eigen::Vector3d>& position) {
  EdgeLengths lengths;
  lengths.value.resize(t.num_edges());
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    lengths.value[e] = (position[t.Tip(h)] - position[t.Tail(h)]).norm();
  }
  return lengths;
}

CornerUv FacesInPlane(const IntrinsicSurface& surface) {
  const auto& [t, lengths, angles, boundary, corners] = surface;
  CornerUv uv;
  uv.value.resize(t.num_halfedges());
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    const double base = lengths.value[t.edge[h + 2]], side = lengths.value[t.edge[h + 1]];
    uv.value[h] = {0, 0};
    uv.value[h + 1] = {base, 0};
    uv.value[h + 2] = {side * std::cos(angles.value[h]), side * std::sin(angles.value[h])};
  }
  return uv;
}

Eigen::VectorXd AngleDifferences(const CornerAngles& from, const CornerAngles& to) {
  return (from.value - to.value).cwiseAbs();
}

}  // namespace cirque

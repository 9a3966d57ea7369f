#include "experiments/common/map_view/picture_panels.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "cirque/math/lattice_pattern.h"

namespace cirque {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr double kMargin = 8;      ///< round what a panel shows, in units
constexpr double kChecks = 12;     ///< pairs of squares along half the image's extent
constexpr double kTowards = 0.01;  ///< of lines before the surface that they lie on
constexpr double kGlobe = 106;     ///< radius of a side of the sphere, in units
constexpr double kSteepest = 0.9999;
constexpr double kManyShare = 0.3;  ///< of the area that looks one way, beyond which that counts
const Rgb kDark(kPatternDark.data()), kLight(kPatternLight.data()), kFlipped(0.85f, 0.1f, 0.1f);

/// The middle of a box and the largest distance from it.
struct Extent {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double radius = 1;
};

Extent ExtentOf(const Points& points) {
  Extent extent;
  if (points.empty()) return extent;
  Eigen::Vector3d low = points[0], high = points[0];
  for (const Eigen::Vector3d& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  extent.middle = (low + high) / 2;
  extent.radius = 0;
  for (const Eigen::Vector3d& p : points) {
    extent.radius = std::max(extent.radius, (p - extent.middle).norm());
  }
  if (extent.radius == 0) extent.radius = 1;
  return extent;
}

/// Per vertex, the sum of its faces' normals times their areas.
Points VertexNormals(const Triangulation& t, const Points& position) {
  Points normals(position.size(), Eigen::Vector3d::Zero());
  for (Index f = 0; f < t.num_faces(); ++f) {
    const Index* v = &t.vertex[3 * f];
    const Eigen::Vector3d normal =
        (position[v[1]] - position[v[0]]).cross(position[v[2]] - position[v[0]]);
    for (int k = 0; k < 3; ++k) normals[v[k]] += normal;
  }
  return normals;
}

/// As the viewer begins, from above and a little aside; from the other side where most of an open
/// surface looks away.
Eigen::Matrix3d Turn(const Points& normals) {
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(0.35, Eigen::Vector3d::UnitX()) *
                                Eigen::AngleAxisd(-0.5, Eigen::Vector3d::UnitY()))
                                   .toRotationMatrix();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double total = 0;
  for (const Eigen::Vector3d& normal : normals) sum += normal, total += normal.norm();
  const bool looks_away = (turn * sum).z() < 0 && sum.norm() > kManyShare * total;
  if (!looks_away) return turn;
  return turn * Eigen::AngleAxisd(std::acos(-1.), Eigen::Vector3d::UnitY()).toRotationMatrix();
}

float Smooth(double from, double to, double value) {
  const double t = std::clamp((value - from) / (to - from), 0., 1.);
  return static_cast<float>(t * t * (3 - 2 * t));
}

/// One of the two colours; grey where what has it is smaller than what can be seen, a point being `width`
/// of its periods wide.
Rgb Blurred(const Rgb& own, double width) {
  const float grey = Smooth(0.35, 1, width);
  return (1 - grey) * own + grey * (kDark + kLight) / 2;
}

/// One of two colours by the square that a place lies in.
Rgb CheckAt(const Eigen::Vector2d& place, double width) {
  const bool odd = (std::floor(2 * place.x()) + std::floor(2 * place.y())) -
                       2 * std::floor((std::floor(2 * place.x()) + std::floor(2 * place.y())) / 2) >
                   0.5;
  return Blurred(odd ? kLight : kDark, width);
}

/// The pattern of a lattice, which its rotations take to itself.
Rgb PatternAt(LatticeKind kind, const Eigen::Vector2d& place, double width) {
  return Blurred(PatternDistance(kind, place) > 0 ? kDark : kLight, width);
}

/// Where Mercator's projection, times a whole number of squares, has a point of the sphere.
Eigen::Vector2d Mercator(const Eigen::Vector3d& point) {
  const Eigen::Vector3d p = point.normalized();
  const double many = std::ceil(kChecks / 2) / std::acos(-1.);
  return many * Eigen::Vector2d(std::atan2(p.y(), p.x()),
                                std::atanh(std::clamp(p.z(), -kSteepest, kSteepest)));
}

/// How far a light-coloured thing is lit whose normal, before the viewer, is this.
float LightOn(const Eigen::Vector3d& normal, double dim) {
  const Eigen::Vector3d light = Eigen::Vector3d(0.3, 0.5, 0.9).normalized();
  const double length = normal.norm();
  const double facing = length > 0 ? std::abs(normal.dot(light)) / length : 1;
  return static_cast<float>(dim + (1 - dim) * facing);
}

double TwiceArea(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return std::abs((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x());
}

/// The surface as it stands before the viewer.
class Stage {
 public:
  Stage(const UvMap& map, double scale) : map_(map), scale_(scale) {
    const Points normals = VertexNormals(mesh(), map.surface.position);
    const Eigen::Matrix3d turn = Turn(normals);
    for (const Eigen::Vector3d& p : map.surface.position) place_.push_back(turn * p);
    FitInto(&place_);
    for (const Eigen::Vector3d& normal : normals) normal_.push_back(turn * normal);
    Points flat;
    for (const Eigen::Vector2d& uv : map.point_uv) flat.emplace_back(uv.x(), uv.y(), 0);
    if (map.point_uv.empty()) return;
    image_ = ExtentOf(flat);
  }

  void DrawFaces(Raster* raster) const {
    for (Index f = 0; f < mesh().num_faces(); ++f) DrawFace(f, raster);
  }

  void DrawSeams(Raster* raster) const {
    if (map_.lattice) return DrawCones(raster);  // along seams there is nothing to be seen
    const Rgb colour(kSeamColour[0], kSeamColour[1], kSeamColour[2]);
    const Eigen::Vector3d towards(0, 0, -kTowards);
    for (const Index h : map_.seams) {
      if (mesh().twin[h] < h) continue;
      raster->Line(place_[mesh().Tail(h)] + towards, place_[mesh().Tip(h)] + towards, 1.3 * scale_,
                   colour);
    }
  }

 private:
  const Triangulation& mesh() const { return map_.surface.triangulation; }

  /// From space into the panel, as large as it can be; depths in the same unit, a half panel.
  void FitInto(Points* points) const {
    if (points->empty()) return;
    Eigen::Vector3d low = points->front(), high = low;
    for (const Eigen::Vector3d& p : *points) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const double size = (high - low).head<2>().maxCoeff();
    const double unit = size > 0 ? 2 / size : 1;
    for (Eigen::Vector3d& p : *points) {
      const Eigen::Vector3d seen = unit * (p - (low + high) / 2);
      p << X(seen.x()), X(-seen.y()), -seen.z();
    }
  }
  double X(double x) const { return scale_ * (kPanel / 2 + x * (kPanel / 2 - kMargin)); }

  /// Dots in the colours of the picture's other ones: there a lattice's pattern has another number of sectors.
  void DrawCones(Raster* raster) const {
    for (const auto& [vertex, sum] : map_.cones) {
      for (const bool ring : {true, false}) {
        const Eigen::Vector3d at =
            place_[vertex] - Eigen::Vector3d(0, 0, (ring ? 1 : 2) * kTowards);
        const auto& colour = sum < 2 * kPi ? kLessColour : kMoreColour;
        raster->Line(at, at, (ring ? 7 : 5) * scale_, ring ? Rgb(1, 1, 1) : Rgb(colour));
      }
    }
  }

  /// In pairs of squares; on a lattice in its periods, a whole number of them to a cell.
  Eigen::Vector2d OnImage(Index h) const {
    const double many = kChecks / image_.radius;
    if (!map_.lattice) return many * (map_.uv.value[h] - image_.middle.head<2>());
    return std::max(1., std::round(many)) * map_.uv.value[h];
  }

  void DrawFace(Index f, Raster* raster) const {
    const Index* v = &mesh().vertex[3 * f];
    const std::array<Eigen::Vector3d, 3> corner = {place_[v[0]], place_[v[1]], place_[v[2]]};
    const double points =
        9 * TwiceArea(corner[0].head<2>(), corner[1].head<2>(), corner[2].head<2>());
    std::array<Eigen::Vector2d, 3> at;
    for (int k = 0; k < 3; ++k) {
      at[k] = map_.IsOnSphere() ? Mercator(map_.on_sphere[v[k]]) : OnImage(3 * f + k);
    }
    const double width = points > 0 ? std::sqrt(TwiceArea(at[0], at[1], at[2]) / points) : 0;
    raster->Triangle(corner, [&](const Eigen::Vector3d& b) -> Rgb {
      const Eigen::Vector3d normal =
          b[0] * normal_[v[0]] + b[1] * normal_[v[1]] + b[2] * normal_[v[2]];
      Eigen::Vector2d place = b[0] * at[0] + b[1] * at[1] + b[2] * at[2];
      if (map_.IsOnSphere()) {
        place = Mercator(b[0] * map_.on_sphere[v[0]] + b[1] * map_.on_sphere[v[1]] +
                         b[2] * map_.on_sphere[v[2]]);
      }
      if (map_.lattice) return LightOn(normal, 0.42) * PatternAt(*map_.lattice, place, width);
      return LightOn(normal, 0.42) * CheckAt(place, map_.IsOnSphere() ? 0 : width);
    });
  }

  const UvMap& map_;
  double scale_;
  Points place_, normal_;
  Extent image_;
};

/// One side of the sphere, `turn` before the viewer, round a place of the panel.
void DrawGlobe(const UvMap& map, const std::vector<Rgb>& colour, const Eigen::Matrix3d& turn,
               const Eigen::Vector2d& centre, double scale, Raster* raster) {
  const Triangulation& mesh = map.surface.triangulation;
  for (Index f = 0; f < mesh.num_faces(); ++f) {
    std::array<Eigen::Vector3d, 3> seen, corner;
    for (int k = 0; k < 3; ++k) {
      seen[k] = turn * map.on_sphere[mesh.vertex[3 * f + k]];
      corner[k] << scale * (centre.x() + kGlobe * seen[k].x()),
          scale * (centre.y() - kGlobe * seen[k].y()), -seen[k].z();
    }
    if (seen[0].z() < 0 && seen[1].z() < 0 && seen[2].z() < 0) continue;
    raster->Triangle(corner, [&](const Eigen::Vector3d& b) -> Rgb {
      return LightOn(b[0] * seen[0] + b[1] * seen[1] + b[2] * seen[2], 0.7) * colour[f];
    });
  }
}

}  // namespace

PanelFit::PanelFit(const UvMap& map) : middle_(Eigen::Vector2d::Zero()) {
  if (map.point_uv.empty()) return;
  Eigen::Vector2d low = map.point_uv[0], high = low;
  for (const Eigen::Vector2d& uv : map.point_uv) low = low.cwiseMin(uv), high = high.cwiseMax(uv);
  middle_ = (low + high) / 2;
  const double size = (high - low).maxCoeff();
  scale_ = size > 0 ? (kPanel - 2 * kMargin) / size : 1;
}

Eigen::Vector2d PanelFit::operator()(const Eigen::Vector2d& uv) const {
  const Eigen::Vector2d from_middle = scale_ * (uv - middle_);
  return {kPanel / 2 + from_middle.x(), kPanel / 2 - from_middle.y()};
}

RgbaImage SurfacePanel(const UvMap& map, double scale) {
  const int side = static_cast<int>(std::lround(scale * kPanel));
  Raster raster(side, side);
  const Stage stage(map, scale);
  stage.DrawFaces(&raster);
  stage.DrawSeams(&raster);
  return raster.Finish();
}

RgbaImage ImagePanel(const UvMap& map, const std::vector<Rgb>& face_colour, double scale) {
  const int side = static_cast<int>(std::lround(scale * kPanel));
  Raster raster(side, side);
  if (map.IsOnSphere()) {
    const Eigen::Matrix3d front = Turn({});
    const Eigen::Matrix3d back =
        Eigen::AngleAxisd(std::acos(-1.), Eigen::Vector3d::UnitY()).toRotationMatrix() * front;
    DrawGlobe(map, face_colour, front, {kPanel / 4, kPanel / 2}, scale, &raster);
    DrawGlobe(map, face_colour, back, {3 * kPanel / 4, kPanel / 2}, scale, &raster);
    return raster.Finish();
  }
  const PanelFit fit(map);
  for (Index f = 0; f < map.surface.triangulation.num_faces(); ++f) {
    std::array<Eigen::Vector3d, 3> corner;
    for (int k = 0; k < 3; ++k) {
      corner[k] << scale * fit(map.uv.value[3 * f + k]), 0;
    }
    const Eigen::Vector3d normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const Rgb colour = normal.z() > 0 ? kFlipped : face_colour[f];  // y points down here
    raster.Triangle(corner, [&](const Eigen::Vector3d&) { return colour; });
  }
  return raster.Finish();
}

}  // namespace cirque

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cirque/verify/report_words.h"
#include "cirque/verify/sphere_check.h"

namespace cirque::verify {
namespace {

std::string Measures(const SphereReport& r) {
  const SphereDistortion& d = r.distortion;
  return Line("orientation",
              fmt::format("{} flipped, {} zero-area (exact)", r.orientations.flipped.size(),
                          r.orientations.zero_area.size())) +
         Line("degree", fmt::format("{:.12g}", r.degree)) +
         Line("Delaunay margin", fmt::format("{:.6g} rad", r.delaunay_margin)) +
         Line("centre of mass",
              fmt::format("{:.3g} uniform, {:.3g} by area", r.centre_uniform, r.centre_by_area)) +
         Line("quasi-conformal", fmt::format("mean {:.6g}, max {:.6g}", d.quasi_conformal_mean,
                                             d.quasi_conformal_max)) +
         Line("angle distortion",
              fmt::format("mean {:.6g} rad, max {:.6g} rad", d.angle_mean, d.angle_max)) +
         Line("log area ratio", fmt::format("min {:.6g}, max {:.6g}, L2 {:.6g}", d.log_area_min,
                                            d.log_area_max, d.log_area_l2));
}

}  // namespace

std::string ToText(const SphereReport& r) {
  std::string text =
      Line(r.noun + "s",
           fmt::format("{}, {}", r.num_faces,
                       r.match.faces.same_order ? "in IN's order" : "matched as a set")) +
      Line("vertices", fmt::format("{}, off the unit sphere by up to {:.3g}", r.num_vertices,
                                   r.radius_deviation));
  if (r.measured) text += Measures(r);
  return text + "verdict: " + r.Verdict() + "\n";
}

std::string ToJson(const SphereReport& r) {
  nlohmann::ordered_json json = {
      {"verdict", r.Verdict()},     {"valid", r.valid()},
      {"errors", r.errors},         {"triangles", r.num_faces},
      {"vertices", r.num_vertices}, {"radius_deviation", r.radius_deviation}};
  if (r.measured) {
    const SphereDistortion& d = r.distortion;
    const nlohmann::ordered_json measures = {
        {"flipped_triangles", r.orientations.flipped.size()},
        {"zero_area_triangles", r.orientations.zero_area.size()},
        {"degree", r.degree},
        {"delaunay_margin", r.delaunay_margin},
        {"centre_of_mass_uniform", r.centre_uniform},
        {"centre_of_mass_by_area", r.centre_by_area},
        {"quasi_conformal_mean", d.quasi_conformal_mean},
        {"quasi_conformal_max", d.quasi_conformal_max},
        {"angle_distortion_mean", d.angle_mean},
        {"angle_distortion_max", d.angle_max},
        {"log_area_min", d.log_area_min},
        {"log_area_max", d.log_area_max},
        {"log_area_l2", d.log_area_l2}};
    json.update(measures);
  }
  return FiniteJson(std::move(json));
}

}  // namespace cirque::verify

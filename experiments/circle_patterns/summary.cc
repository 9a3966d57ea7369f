#include "experiments/circle_patterns/summary.h"

#include <fmt/format.h>

#include "cirque/core/solve_summary.h"

namespace cirque {
namespace {

double ValueOr(const Certificate& certificate, const std::string& name, double fallback) {
  const auto found = certificate.values.find(name);
  return found == certificate.values.end() ? fallback : found->second;
}

/// What was asked of the shape, as far as the map has it.
std::string DomainSummary(const Certificate& c) {
  const auto value = [&](const char* name) { return ValueOr(c, name, kUnset); };
  std::string text;
  if (c.values.count("boundary_circle_error")) {
    text += fmt::format(
        "disk        off the circle {:.1e}, centres of mass {:.1e} boundary {:.1e} area, "
        "boundary spread {:.0e}\n",
        value("boundary_circle_error"), value("boundary_centre_of_mass"),
        value("area_centre_of_mass"), value("boundary_spread"));
  }
  if (c.values.count("conformal_modulus")) {
    text += fmt::format("rectangle   conformal modulus {:.12g}, opposite sides differ by {:.1e}\n",
                        value("conformal_modulus"), value("opposite_side_mismatch"));
  }
  return text;
}

std::string PlanarSummary(const Certificate& c) {
  const auto value = [&](const char* name) { return ValueOr(c, name, kUnset); };
  std::string text = fmt::format(
      "angles      {:.0f} steps, smallest corner {:.2e} rad, intersection {:.2e} rad, gap {:.1e}\n",
      value("angle_iterations"), value("smallest_angle"), value("smallest_theta"),
      value("angle_gap"));
  text +=
      fmt::format("radii       {:.0f} steps, gradient {:.1e} rad, gap {:.1e}, log range {:.1f}\n",
                  value("radii_iterations"), value("radii_gradient"), value("radii_gap"),
                  value("log_radius_range"));
  text += fmt::format(
      "map         {:.0f} flipped triangles, {}, quasi-conformal {:.5f} mean {:.4g} max\n",
      value("flipped_triangles"), c.overlap, value("quasi_conformal_mean"),
      value("quasi_conformal_max"));
  if (value("cones") > 0 || value("seams") > 0) {
    text += fmt::format(
        "cut         {:.0f} cones, {:.0f} seams, length {:.2f}, rotation {:.1e} rad, gap {:.1e}\n",
        value("cones"), value("seams"), value("cut_length"), value("seam_rotation_mismatch"),
        value("seam_gap"));
  }
  if (value("cone_repairs") > 0) {
    text += fmt::format("cones       {:.0f} moved, {:.0f} widened, where they were infeasible\n",
                        value("cones_moved"), value("cones_widened"));
  }
  if (value("refinement_steps") >= 0) {
    text +=
        fmt::format("cones       {:.0f} steps of refinement, area distortion {:.4f} to {:.4f}\n",
                    value("refinement_steps"), value("refinement_area_distortion_before"),
                    value("refinement_area_distortion_after"));
  }
  if (value("map_refinement_steps") >= 0) {
    text += fmt::format("refinement  {:.0f} steps, objective {:.6g} to {:.6g}\n",
                        value("map_refinement_steps"), value("map_refinement_before"),
                        value("map_refinement_after"));
  }
  return text + DomainSummary(c);
}

std::string SphereSummary(const Certificate& c) {
  const auto value = [&](const char* name) { return ValueOr(c, name, kUnset); };
  return fmt::format(
             "pole        vertex {:.0f} of {:.0f} triangles, intersection {:.2e} rad, log range "
             "{:.1f}\n",
             value("pole") + 1, value("pole_corners"), value("delaunay_margin"),
             value("log_radius_range")) +
         fmt::format(
             "map         {:.0f} flipped triangles, {}, quasi-conformal {:.5f} mean {:.4g} max\n",
             value("flipped_triangles"), c.overlap, value("quasi_conformal_mean"),
             value("quasi_conformal_max")) +
         fmt::format(
             "sphere      centre of mass {:.1e}, log area ratio {:.3f} L2, angles {:.2e} rad mean "
             "{:.2e} max\n",
             value("centre_of_mass"), value("log_area_ratio_l2"), value("angle_distortion_mean"),
             value("angle_distortion_max"));
}

}  // namespace

std::string Summary(const Certificate& c) {
  return c.values.count("degree") ? SphereSummary(c) : PlanarSummary(c);
}

}  // namespace cirque

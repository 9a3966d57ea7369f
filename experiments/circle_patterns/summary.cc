#include <cmath>

#include <fmt/format.h>

#include "cirque/core/count.h"

#include "experiments/circle_patterns/outputs.h"

namespace cirque {
namespace {

constexpr double kWideRange = 20;  ///< of log areas

/// Of needles whose edge lengths are those of no triangle nothing is measured.
std::string Distortion(const DistortionSummary& of) {
  if (!std::isfinite(of.quasi_conformal_mean)) return "no triangle wide enough to be measured";
  return fmt::format("quasi-conformal {:.5f} mean {:.4g} max", of.quasi_conformal_mean,
                     of.quasi_conformal_max);
}

std::string MapLine(const Certificate& c) {
  return fmt::format("map         {}, {}, {}\n",
                     Count(c.layout ? c.layout->flipped_triangles : 0, "flipped triangle"),
                     c.overlap, Distortion(c.distortion.value_or(DistortionSummary())));
}

std::string ScalesLine(const EquivalenceSummary& scales) {
  return fmt::format("scales      {}, angle sums to {:.1e} rad, {}, log range {:.1f}{}\n",
                     Count(scales.scales_iterations, "step"), scales.scales_residual,
                     Count(scales.ptolemy_flips, "Ptolemy flip"), scales.log_scale_range,
                     scales.doubled ? ", on the double" : "");
}

std::string ExactLine(const Certificate& c) {
  if (!c.exact_map) return "";
  const bool flipped = c.layout && c.layout->flipped_triangles > 0;
  const std::string instead =
      flipped ? "exact       instead of that at the mesh's vertices, which has flipped triangles\n"
              : "";
  const std::string origins =
      c.exact_map->exact_origins
          ? fmt::format("exact       in {}, each about an origin of its own, one upon the other\n",
                        Count(*c.exact_map->exact_origins, "rigid piece"))
          : "";
  return instead +
         fmt::format(
             "exact       quasi-conformal {:.5f} mean {:.4g} max, {:.2f} faces for one of the "
             "input, "
             "{} at most\n",
             c.exact_map->exact_quasi_conformal_mean, c.exact_map->exact_quasi_conformal_max,
             c.exact_map->exact_faces_ratio, c.exact_map->exact_faces_worst) +
         origins;
}

std::string SolveLines(const Certificate& c) {
  if (c.equivalence) return ScalesLine(*c.equivalence);
  if (!c.angle_fit) return "";  // nothing was solved: a flat metric, a single triangle
  const AngleFitSummary angles = c.angle_fit.value_or(AngleFitSummary());
  const RadiiSummary radii = c.radii.value_or(RadiiSummary());
  if (angles.epsilon == 0) {
    return fmt::format(
        "angles      those of the surface, which is flat: smallest corner {:.2e} rad\n",
        angles.smallest_angle);
  }
  return fmt::format(
             "angles      {}, smallest corner {:.2e} rad, intersection {:.2e} rad, gap "
             "{:.1e}\n",
             Count(angles.angle_iterations, "step"), angles.smallest_angle, angles.smallest_theta,
             angles.angle_gap) +
         fmt::format("radii       {}, gradient {:.1e} rad, gap {:.1e}, log range {:.1f}\n",
                     Count(radii.radii_iterations, "step"), radii.radii_gradient, radii.radii_gap,
                     radii.log_radius_range);
}

std::string ConeLines(const Certificate& c) {
  std::string text;
  const int cones = c.layout ? c.layout->cones.value_or(0) : 0;
  if (c.seams && (cones > 0 || c.seams->seams > 0)) {
    text += fmt::format("cut         {}, {}, length {:.2f}, rotation {:.1e} rad, gap {:.1e}\n",
                        Count(cones, "cone"), Count(c.seams->seams, "seam"),
                        c.layout->cut_length.value_or(0), c.seams->seam_rotation_mismatch,
                        c.seams->seam_gap);
  }
  if (text.empty() && c.layout && c.layout->cut_length.value_or(0) > 0) {
    text += fmt::format("cut         {}, length {:.2f}\n",
                        Count(c.layout->patches.value_or(1), "chart"), *c.layout->cut_length);
  }
  if (c.holonomy && c.rotations) {
    text += fmt::format(
        "rotations   {} along loops, to {:.1e} rad what was asked for; {:.1e} rad were left to the "
        "angles\n",
        c.rotations->rotations.size(), c.holonomy->holonomy_miss, c.holonomy->holonomy_miss_before);
  }
  if (c.loops) {
    const LoopsSummary& loops = *c.loops;
    text += fmt::format("loops       {}, rotations missed by up to {:.1e} rad (loop {}), ",
                        Count(loops.rotations.size(), "loop"), loops.loop_miss,
                        loops.loop_that_misses + 1);
    text += loops.loops_to_meet == 1
                ? fmt::format("{} of the angles closed {:.2g} rad, at the price of conformality\n",
                              Count(loops.loop_steps.value_or(0), "step"),
                              loops.loop_miss_before.value_or(0))
                : "as the cones have them\n";
  }
  if (c.integers && c.integers->integer_gap) {
    text += fmt::format(
        "lattice     cones and seams on it to {:.1e} cells; vertices moved by up to {:.2f} cells\n",
        *c.integers->integer_gap, *c.integers->integer_shift);
  }
  if (c.layout && c.layout->further_cut_edges.value_or(0) > 0) {
    text += fmt::format(
        "cut         {} as given and {} beyond, since those left no disk or cones inside\n",
        Count(*c.layout->given_cut_edges, "edge"), *c.layout->further_cut_edges);
  }
  if (c.cone_rounding) {
    text += fmt::format(
        "cones       {} rounded by up to {:.1e} pi, since the file's digits miss Gauss-Bonnet by "
        "{:.1e} pi\n",
        c.cone_rounding->cones_rounded, c.cone_rounding->cone_rounding_largest / kPi,
        c.cone_rounding->cone_sum_missed / kPi);
  }
  if (c.cone_budget) {
    text += fmt::format("cones       {} instead of {}, since fewer cannot add up as they must\n",
                        c.cone_budget->cones_needed, c.cone_budget->cones_asked);
  }
  if (c.cone_repair && c.cone_repair->cone_repairs > 0) {
    text += fmt::format("cones       {} moved, {} widened, where they were infeasible\n",
                        c.cone_repair->cones_moved, c.cone_repair->cones_widened);
  }
  if (c.cone_refinement) {
    text += fmt::format("cones       {} refined, area distortion {:.4f} to {:.4f}\n",
                        Count(c.cone_refinement->refinement_steps, "time"),
                        c.cone_refinement->refinement_area_distortion_before,
                        c.cone_refinement->refinement_area_distortion_after);
  }
  return text;
}

/// What was asked of the shape, as far as the map has it.
std::string DomainLines(const Certificate& c) {
  std::string text;
  if (c.disk) {
    text += fmt::format(
        "disk        off the circle {:.1e}, centres of mass {:.1e} boundary {:.1e} area, "
        "boundary spread {:.0e}\n",
        c.disk->boundary_circle_error, c.disk->boundary_centre_of_mass, c.disk->area_centre_of_mass,
        c.disk->boundary_spread);
  }
  if (c.polygon && c.polygon->conformal_modulus) {
    text += fmt::format("rectangle   conformal modulus {:.12g}, opposite sides differ by {:.1e}\n",
                        *c.polygon->conformal_modulus,
                        c.polygon->opposite_side_mismatch.value_or(kUnset));
  }
  return text;
}

std::string LadderLine(const Certificate& c) {
  if (!c.ladder || c.ladder->made_with.empty()) return "";
  return fmt::format("ladder      made with {}, since {} ({} tried)\n", c.ladder->made_with,
                     c.ladder->since, c.ladder->rungs_tried);
}

std::string InjectivityLine(const Certificate& c) {
  if (!c.injectivity) return "";
  const InjectivitySummary& done = *c.injectivity;
  if (done.made_by == "curvature") {
    return fmt::format(
        "injective   by its boundary, whose angle sums changed by up to {:.2f} rad\n",
        done.boundary_turned.value_or(0));
  }
  if (done.made_by == "descent") {
    return fmt::format("injective   by descent, {}, with free seams\n",
                       Count(done.descent_steps.value_or(0), "step"));
  }
  if (done.made_by.empty()) return "injective   not, by any stage: see the certificate\n";
  return fmt::format("injective   in {}, side by side\n", Count(done.charts, "chart"));
}

std::string PeriodicLine(const Certificate& c) {
  if (!c.periodic) return "";
  const PeriodicSummary& periodic = *c.periodic;
  if (periodic.modulus_imaginary) {
    return fmt::format("torus       tau {:.12g} + {:.12g} i, seams off by {:.1e} before exact\n",
                       periodic.modulus_real.value_or(0), *periodic.modulus_imaginary,
                       periodic.period_mismatch);
  }
  if (periodic.inner_radius) {
    return fmt::format(
        "annulus     modulus {:.12g}, inner radius {:.12g}, off the circles {:.1e}\n",
        periodic.annulus_modulus.value_or(kUnset), *periodic.inner_radius,
        periodic.circle_error.value_or(kUnset));
  }
  return fmt::format("strip       modulus {:.12g}, period {:.12g}\n",
                     periodic.annulus_modulus.value_or(kUnset),
                     periodic.strip_period.value_or(kUnset));
}

/// What single precision makes of the map, and areas that range far.
std::string RangeLine(const Certificate& c) {
  const int vanishing = c.layout ? c.layout->float32_vanishing_triangles.value_or(0) : 0;
  const double range =
      c.distortion ? c.distortion->log_area_ratio_max - c.distortion->log_area_ratio_min : 0;
  if (vanishing == 0 && !(range > kWideRange)) return "";
  const bool has_cones = c.layout && c.layout->cones.value_or(0) > 0;
  const std::string lost =
      vanishing > 0 ? ", " + Count(vanishing, "triangle") + " lost in single precision" : "";
  return fmt::format("warning     areas range over e^{:.0f}{}: {}\n", range, lost,
                     has_cones ? "more cones (--cones=greedy:cones=N)" : "cones (--cones=greedy)");
}

std::string PlanarSummary(const Certificate& c) {
  std::string text = SolveLines(c) + MapLine(c) + InjectivityLine(c) + ExactLine(c) + ConeLines(c) +
                     LadderLine(c) + RangeLine(c);
  if (c.map_refinement && std::isfinite(c.map_refinement->map_refinement_before)) {
    text += fmt::format("refinement  {}, objective {:.6g} to {:.6g}\n",
                        Count(c.map_refinement->map_refinement_steps, "step"),
                        c.map_refinement->map_refinement_before,
                        c.map_refinement->map_refinement_after);
  }
  return text + DomainLines(c) + PeriodicLine(c);
}

/// "mean 1.0021 max 1.2" of a map, else why there is none.
std::string ComponentLine(const Certificate& c) {
  const ComponentSummary of = c.component.value_or(ComponentSummary());
  const std::string name =
      fmt::format("{} from face {} on: ", Count(of.faces, "face"), of.first_face + 1);
  if (c.layout && c.distortion) {
    return fmt::format("component   {}{}{}\n", name, Distortion(*c.distortion),
                       c.message.empty() ? "" : "; " + c.message);
  }
  return fmt::format("no map      {}{}\n", name, c.message);
}

/// Of few components a line each, of many those that failed.
std::string SeveralSummary(const Certificate& c) {
  constexpr int kListed = 10;
  const auto& components = c.components;
  const bool all = static_cast<int>(components.size()) <= kListed;
  std::string text;
  int failed = 0, listed = 0;
  for (const Certificate& part : components) {
    const bool has_map = part.layout && part.distortion;
    if (!has_map) ++failed;
    if ((has_map && !all) || listed >= kListed) continue;
    text += ComponentLine(part);
    ++listed;
  }
  const double area_used = c.layout ? c.layout->area_used.value_or(kUnset) : kUnset;
  text += fmt::format("components  {} mapped, {} without a map, {} on {:.0f} % of the square\n",
                      static_cast<int>(components.size()) - failed, failed,
                      Count(c.atlas->atlas_patches, "patch"), 100 * area_used);
  return text + MapLine(c) + ExactLine(c) + ConeLines(c) + RangeLine(c);
}

std::string SphereSummaryText(const Certificate& c) {
  const SphereSummary& sphere = *c.sphere;
  return fmt::format(
             "pole        vertex {} of {} triangles, intersection {:.2e} rad, log range {:.1f}\n",
             sphere.pole_vertex + 1, sphere.pole_corners, sphere.delaunay_margin.value_or(kUnset),
             c.radii ? c.radii->log_radius_range : kUnset) +
         MapLine(c) + ExactLine(c) +
         fmt::format(
             "sphere      centre of mass {:.1e}, log area ratio {:.3f} L2, angles {:.2e} rad mean "
             "{:.2e} max\n",
             sphere.centre_of_mass.value_or(kUnset),
             c.distortion ? c.distortion->log_area_ratio_l2 : kUnset,
             sphere.angle_distortion_mean.value_or(kUnset),
             sphere.angle_distortion_max.value_or(kUnset));
}

}  // namespace

std::string Summary(const Certificate& c) {
  if (!c.components.empty()) return SeveralSummary(c);
  return c.sphere ? SphereSummaryText(c) : PlanarSummary(c);
}

}  // namespace cirque

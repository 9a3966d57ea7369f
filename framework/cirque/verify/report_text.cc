#include <algorithm>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/verify/findings.h"
#include "cirque/verify/map_check.h"

namespace cirque::verify {
namespace {

std::string Line(const std::string& name, const std::string& text) {
  return fmt::format("{:<18}{}\n", name, text);
}

std::string MeshLines(const MapReport& report) {
  const Correspondence& match = report.correspondence;
  std::string order = match.same_order ? "in IN's order" : "matched as a set";
  if (!match.reversed.empty()) {
    order +=
        fmt::format(", {} reversed in OUT ({})", match.reversed.size(), IdList(match.reversed));
  }
  if (!report.turned.empty()) {
    order += fmt::format(", {} against their neighbours in OUT ({}) and judged turned",
                         report.turned.size(), IdList(report.turned));
  }
  return Line("triangles", fmt::format("{}, {}", report.num_triangles, order)) +
         Line("vertices", fmt::format("{}, largest displacement {:.3g} of the bounding box",
                                      report.num_vertices, report.displacement.largest));
}

std::string ConeList(const std::vector<Cone>& cones) {
  constexpr std::size_t kShown = 8;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < std::min(kShown, cones.size()); ++i) {
    words.push_back(fmt::format("{}: {:.6g} pi", cones[i].vertex, cones[i].angle_sum / kPi));
  }
  if (cones.size() > kShown) words.push_back(fmt::format("and {} more", cones.size() - kShown));
  return Join(words);
}

std::string AngleLines(const AngleMeasures& angles) {
  std::string text =
      Line("angle sums",
           fmt::format("2 pi at {} off the seams, largest deviation {:.3g} rad",
                       Count(angles.num_plain, "inner vertex"), angles.largest_plain_deviation));
  if (angles.num_on_seam > 0) {
    const std::string flat =
        fmt::format("{} on seams: {} at 2 pi within {:.3g} rad, {}", angles.num_on_seam,
                    angles.num_on_seam - static_cast<Index>(angles.cones.size()),
                    angles.largest_flat_seam_deviation, Count(angles.cones.size(), "cone"));
    text += Line("", angles.cones.empty() ? flat : flat + " (" + ConeList(angles.cones) + ")");
  }
  if (angles.largest_target_deviation >= 0) {
    text += Line("targets", fmt::format("largest deviation {:.3g} rad, {} off",
                                        angles.largest_target_deviation, angles.off_target.size()));
  }
  return text + Line("smallest angle", fmt::format("{:.6g} rad", angles.smallest_angle)) +
         Line("Delaunay margin", fmt::format("{:.6g} rad", angles.delaunay_margin));
}

std::string QualityLines(const QualityFigures& quality) {
  if (quality.worst_triangle == kNone) return quality.lines;
  return quality.lines +
         Line("least conformal", fmt::format("triangle {}", quality.worst_triangle));
}

std::string OverlapLines(const OverlapResult& overlap, Index num_patches) {
  const std::string many = overlap.num_crossings >= OverlapResult::kMaxCrossings ? "at least " : "";
  std::string text = fmt::format(
      "{}, {} of {}, {}{}", Count(num_patches, "patch"), Count(overlap.num_boundary_loops, "loop"),
      Count(overlap.num_boundary_edges, "edge"), many, Count(overlap.num_crossings, "crossing"));
  if (overlap.num_crossings > 0) {
    text += fmt::format(" (first: triangles {} and {})", overlap.first_crossing.first / 3,
                        overlap.first_crossing.second / 3);
  }
  if (!overlap.wrapped_boundary.empty()) {
    text +=
        fmt::format(", more than 2 pi at {} ({})", Count(overlap.wrapped_boundary.size(), "vertex"),
                    IdList(overlap.wrapped_boundary));
  }
  if (overlap.nested_patches.first != kNone) {
    text += fmt::format(", patch {} on patch {}", overlap.nested_patches.second,
                        overlap.nested_patches.first);
  }
  return Line("UV boundary", text) +
         Line("injective",
              overlap.overlaps() ? "no: locally injective, boundary overlaps itself" : "proven");
}

}  // namespace

std::string ToText(const MapReport& report) {
  std::string text = MeshLines(report);
  if (report.orientations) {
    text += Line("orientation", fmt::format("{} flipped, {} zero-area (exact)",
                                            report.orientations->flipped.size(),
                                            report.orientations->zero_area.size()));
  }
  if (report.angles) text += AngleLines(*report.angles);
  if (report.seams && report.seams->num_edges > 0) {
    text += Line("seams", fmt::format("{}, lengths differ by up to {:.3g}",
                                      Count(report.seams->num_edges, "edge"),
                                      report.seams->largest_difference));
  }
  if (report.disk) {
    text += Line("unit circle", fmt::format("{} of the boundary off by up to {:.3g}, {} turn",
                                            Count(report.disk->num_vertices, "vertex"),
                                            report.disk->largest_error, report.disk->turns));
  }
  if (report.overlap) text += OverlapLines(*report.overlap, report.num_patches);
  if (report.quality) text += QualityLines(*report.quality);
  return text + "verdict: " + report.Verdict() + "\n";
}

}  // namespace cirque::verify

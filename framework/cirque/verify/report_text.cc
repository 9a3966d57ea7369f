#include <algorithm>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/verify/findings.h"
#include "cirque/verify/map_check.h"
#include "cirque/verify/report_words.h"

namespace cirque::verify {
namespace {

std::string MatchLine(const MapReport& report) {
  const Correspondence& faces = report.match.faces;
  std::string text = fmt::format("{}, {}", report.num_faces,
                                 faces.same_order ? "in IN's order" : "matched as a set");
  if (!faces.pieces.empty()) {
    text += fmt::format(", {} cut up in OUT", Count(faces.pieces.size(), "polygon"));
  }
  if (!faces.reversed.empty()) {
    text += fmt::format(", {} reversed in OUT ({}): judged by IN's orientation",
                        faces.reversed.size(), IdList(faces.reversed));
  }
  if (!report.turned.empty()) {
    text += fmt::format(", {} against their neighbours in IN ({}) and judged turned",
                        report.turned.size(), IdList(report.turned));
  }
  return Line(report.noun + "s", text);
}

std::string RepairLine(const MapReport& report) {
  if (report.set_aside.empty() && report.num_split == 0) return "";
  return Line("repaired",
              fmt::format("{} of IN set aside{}, {} added where fans of faces meet",
                          Count(report.set_aside.size(), "face"),
                          report.set_aside.empty() ? "" : " (" + IdList(report.set_aside) + ")",
                          Count(report.num_split, "vertex")));
}

std::string MeshLines(const MapReport& report) {
  const MeshMatch& match = report.match;
  std::string text =
      RepairLine(report) + MatchLine(report) +
      Line("vertices",
           fmt::format("{}{}, largest displacement {:.3g} of the bounding box", report.num_vertices,
                       match.by_position ? ", matched by their positions" : "",
                       match.displacement.largest));
  if (match.scale != 1 || !match.shift.isZero(0)) {
    text +=
        Line("scaled", fmt::format("OUT is IN times {:.9g}, moved by ({:.9g}, {:.9g}, {:.9g})",
                                   match.scale, match.shift.x(), match.shift.y(), match.shift.z()));
  }
  return text;
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

std::string QualityLines(const QualityFigures& quality, const std::string& noun) {
  if (quality.worst_triangle == kNone) return quality.lines;
  return quality.lines +
         Line("least conformal", fmt::format("{} {}", noun, quality.worst_triangle));
}

std::string SeamLines(const UvComplex& complex, const SeamAgreement& seams) {
  std::string text = SeamStatement(complex);
  if (complex.num_seam_edges > 0) {
    text += fmt::format(", lengths differ by up to {:.3g}", seams.largest_difference);
  }
  if (seams.worst_rotation != kNone) {
    text += fmt::format(", rotations off by up to {:.3g} rad", seams.largest_rotation_gap);
  }
  return Line("seams", text);
}

std::string OverlapLines(const UvComplex& complex, const OverlapResult& overlap) {
  std::string text = fmt::format("{} of {}", Count(overlap.num_boundary_loops, "loop"),
                                 Count(overlap.num_boundary_edges, "edge"));
  const std::vector<std::string> errors = OverlapErrors(complex, overlap);
  if (!errors.empty()) text += ": " + Join(errors, "; ");
  return Line("UV boundary", text) +
         Line("injective",
              overlap.overlaps() ? "no: locally injective, boundary overlaps itself" : "proven");
}

}  // namespace

std::string ToText(const MapReport& report) {
  std::string text = MeshLines(report);
  if (report.orientations) {
    std::string found =
        fmt::format("{} flipped, {} zero-area (exact)", report.orientations->flipped.size(),
                    report.orientations->zero_area.size());
    if (const std::size_t folded = report.orientations->folded.size(); folded > 0) {
      found += fmt::format(", {} with a border that is not simple", folded);
    }
    text += Line("orientation", found);
  }
  if (report.angles) text += AngleLines(*report.angles);
  if (report.seams) text += SeamLines(*report.complex, *report.seams);
  if (report.disk) {
    text += Line("unit circle", fmt::format("{} of the boundary off by up to {:.3g}, {} turn",
                                            Count(report.disk->num_vertices, "vertex"),
                                            report.disk->largest_error, report.disk->turns));
  }
  if (report.holes) {
    text += Line("round holes", fmt::format("{}, vertices off their circles by up to {:.3g}",
                                            report.holes->holes, report.holes->largest_error));
  }
  if (report.overlap) text += OverlapLines(*report.complex, *report.overlap);
  if (report.quality) text += QualityLines(*report.quality, report.noun);
  return text + "verdict: " + report.Verdict() + "\n";
}

}  // namespace cirque::verify

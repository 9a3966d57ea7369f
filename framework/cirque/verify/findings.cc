#include "cirque/verify/findings.h"

#include <fmt/format.h>

#include "cirque/core/text.h"

namespace cirque::verify {

std::string Count(std::size_t number, const std::string& singular) {
  if (number == 1) return fmt::format("1 {}", singular);
  if (singular.ends_with("vertex")) {
    return fmt::format("{} {}vertices", number, singular.substr(0, singular.size() - 6));
  }
  return fmt::format("{} {}{}", number, singular, singular.ends_with("ch") ? "es" : "s");
}

std::string NameEdge(const UvComplex& complex, Index halfedge) {
  return fmt::format("edge ({}, {}) of triangle {}", complex.mesh().Tail(halfedge),
                     complex.mesh().Tip(halfedge), halfedge / 3);
}

std::vector<std::string> OrientationErrors(const Orientations& found, Index num_triangles) {
  std::vector<std::string> errors;
  const auto num_judged = static_cast<std::size_t>(num_triangles) - found.zero_area.size();
  if (!found.flipped.empty() && found.flipped.size() == num_judged) {
    errors.push_back(fmt::format(
        "all {} flipped: the map is mirrored as a whole; exchange u and v, or negate one of them",
        Count(num_judged, "triangle")));
  } else if (!found.flipped.empty()) {
    errors.push_back(fmt::format("{} ({})", Count(found.flipped.size(), "flipped triangle"),
                                 IdList(found.flipped)));
  }
  if (!found.zero_area.empty()) {
    errors.push_back(fmt::format("{} ({})", Count(found.zero_area.size(), "zero-area triangle"),
                                 IdList(found.zero_area)));
  }
  return errors;
}

std::vector<std::string> AngleErrors(const AngleMeasures& found, double tolerance) {
  std::vector<std::string> errors;
  if (!found.wrapped.empty()) {
    errors.push_back(fmt::format("the triangles do not turn exactly once round {} ({})",
                                 Count(found.wrapped.size(), "vertex"), IdList(found.wrapped)));
  }
  if (!found.off_target.empty()) {
    errors.push_back(fmt::format(
        "{} with a wrong angle sum ({}): off the target by up to {:.3g} rad, {:.3g} allowed",
        Count(found.off_target.size(), "vertex"), IdList(found.off_target),
        found.largest_target_deviation, tolerance));
  }
  return errors;
}

std::vector<std::string> OverlapErrors(const UvComplex& complex, const OverlapResult& found) {
  std::vector<std::string> errors;
  if (found.num_crossings > 0) {
    errors.push_back(fmt::format("the boundary overlaps itself: {} crosses {}",
                                 NameEdge(complex, found.first_crossing.first),
                                 NameEdge(complex, found.first_crossing.second)));
  }
  if (!found.wrapped_boundary.empty()) {
    errors.push_back(fmt::format("the map goes round {} of its boundary by more than 2 pi ({})",
                                 Count(found.wrapped_boundary.size(), "vertex"),
                                 IdList(found.wrapped_boundary)));
  }
  if (found.nested_patches.first != kNone) {
    errors.push_back(fmt::format("patch {} lies on patch {}", found.nested_patches.second,
                                 found.nested_patches.first));
  }
  return errors;
}

}  // namespace cirque::verify

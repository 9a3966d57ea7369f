#include "cirque/verify/findings.h"

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/verify/report_words.h"

namespace cirque::verify {

std::vector<std::string> OrientationErrors(const Orientations& found, const std::string& noun) {
  std::vector<std::string> errors;
  if (!found.flipped.empty() && found.num_upright == 0) {
    errors.push_back(fmt::format(
        "all {} flipped: the map is mirrored as a whole; exchange u and v, or negate one of them",
        Count(found.flipped.size(), noun)));
  } else if (!found.flipped.empty()) {
    errors.push_back(fmt::format("{} ({})", Count(found.flipped.size(), "flipped " + noun),
                                 IdList(found.flipped)));
  }
  if (!found.zero_area.empty()) {
    errors.push_back(fmt::format("{} ({})", Count(found.zero_area.size(), "zero-area " + noun),
                                 IdList(found.zero_area)));
  }
  if (!found.folded.empty()) {
    errors.push_back(fmt::format("{} whose border crosses or touches itself ({})",
                                 Count(found.folded.size(), noun), IdList(found.folded)));
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
  if (!found.wrapped_boundary.empty()) {
    errors.push_back(fmt::format("the map goes round {} of its boundary by more than 2 pi ({})",
                                 Count(found.wrapped_boundary.size(), "vertex"),
                                 IdList(found.wrapped_boundary)));
  }
  if (!found.overlap) return errors;
  const auto [a, b] = *found.overlap;
  const Index patch_a = complex.patch[a / 3], patch_b = complex.patch[b / 3];
  const std::string edges =
      fmt::format("{} {} {}", NameEdge(complex, a), found.crosses ? "crosses" : "lies beside",
                  NameEdge(complex, b));
  errors.push_back(patch_a == patch_b
                       ? fmt::format("the boundary overlaps itself: {}", edges)
                       : fmt::format("patch {} overlaps patch {}: {}", patch_a, patch_b, edges));
  return errors;
}

}  // namespace cirque::verify

#pragma once

#include <string>
#include <string_view>

#include "cirque/core/status.h"
#include "cirque/math/closed_curve.h"

namespace cirque {

/// The curve that the option `curve` means: a file (ParseCurve), or an ellipse, "ellipse:ratio=2" (its
/// half axes ratio and 1). Errors (invalid input): the file's; an option of the ellipse that is none, or
/// not within [1, 100].
StatusOr<ClosedCurve> CurveOf(const std::string& option);

/// The closed curve of a file: a line `x y` for each of its points in order, either way round, the last
/// one joined to the first. '#' begins a comment, empty lines are skipped. Errors (invalid input): with
/// file:line a line that is not two numbers; those of ClosedCurve::Through.
StatusOr<ClosedCurve> ParseCurve(const std::string& path, std::string_view text);

}  // namespace cirque

#include "cirque/domains/curves.h"

#include <optional>
#include <utility>
#include <vector>

#include "cirque/core/option_table.h"
#include "cirque/core/text.h"
#include "cirque/io/file_input.h"

namespace cirque {
namespace {

constexpr char kEllipse[] = "ellipse";
constexpr int kPoints = 28800;  ///< of an ellipse: fine beside the edges of a boundary

struct EllipseOptions {
  double ratio = 2;
};

const OptionTable<EllipseOptions>& EllipseOptionTable() {
  static const OptionTable<EllipseOptions> kTable(
      kEllipse, {Option<EllipseOptions>("ratio", &EllipseOptions::ratio,
                                        "of the longer half axis to the shorter one")
                     .Between(1, 100)});
  return kTable;
}

}  // namespace

StatusOr<ClosedCurve> CurveOf(const std::string& option) {
  const StatusOr<NameWithOptions> parsed = ParseNameWithOptions(option);
  if (parsed.ok() && parsed->name == kEllipse) {
    EllipseOptions ellipse;
    if (Status s = EllipseOptionTable().Set(parsed->options, &ellipse); !s.ok()) return s;
    return Ellipse(ellipse.ratio, kPoints);
  }
  const StatusOr<std::string> text = ReadFileContent(option);
  if (!text.ok()) {
    const bool misspelt = parsed.ok() && !NearestWord(parsed->name, {kEllipse}).empty();
    return misspelt ? text.status().In(UnknownName("curve", parsed->name, {kEllipse}))
                    : text.status();
  }
  return ParseCurve(option, *text);
}

StatusOr<ClosedCurve> ParseCurve(const std::string& path, std::string_view text) {
  TextScanner scanner(path, text);
  std::vector<Eigen::Vector2d> points;
  while (scanner.NextLine()) {
    const std::optional<double> x = scanner.Number();
    if (!x) return scanner.Expected("a point of the curve, x and y");
    const std::optional<double> y = scanner.Number();
    if (!y || !scanner.AtLineEnd()) return scanner.Expected("x and y of a point, and no more");
    points.emplace_back(*x, *y);
  }
  const StatusOr<ClosedCurve> curve = ClosedCurve::Through(std::move(points));
  return curve.ok() ? curve : curve.status().In(path);
}

}  // namespace cirque

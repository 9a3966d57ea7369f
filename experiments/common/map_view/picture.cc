#include "experiments/common/map_view/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "cirque/core/count.h"
#include "cirque/metrics/distortion_measure.h"
#include "cirque/metrics/mapped_faces.h"
#include "cirque/metrics/measure_files.h"

#include "experiments/common/map_view/html.h"
#include "experiments/common/map_view/map_payload.h"
#include "experiments/common/map_view/picture_panels.h"
#include "experiments/common/map_view/raster.h"
#include "experiments/common/map_view/stroke_font.h"

namespace cirque {
namespace {

constexpr double kGap = 24;  ///< round the panels, in units
constexpr double kWidth = 3 * kGap + 2 * kPanel, kHeight = kPanel + 110;
constexpr double kTop = 14, kSecond = 2 * kGap + kPanel;  ///< of the panels; left end of the second
constexpr double kSvgScale = 2, kPngScale = 1.5;          ///< pixels a unit
constexpr double kFontSize = 13, kStrokeSize = 9;  ///< size of words: of a font, of drawn figures
constexpr double kGrid = 0.1;                      ///< ends of lines are rounded to this, in units
constexpr int kStops = 24;                         ///< of the bar of colours
constexpr double kBarWidth = 150, kBarHeight = 10;

/// What things are painted with: a class of the SVG, light there and in the PNG, and dark.
struct Paint {
  std::string name, light, dark;
};
const std::vector<Paint>& Paints() {
  static const std::vector<Paint> kTable = {
      {"page", "#ffffff", "#14171b"},  {"ink", "#1d2127", "#e6e8eb"},
      {"quiet", "#5b6470", "#a0a8b3"}, {"boundary", "#262b33", "#c9ced6"},
      {"seam", "#e01f59", "#ff4d80"},  {"ring", "#ffffff", "#ffffff"},
      {"less", "#ed730d", "#ed730d"},  {"more", "#8033bf", "#9a5bd0"}};
  return kTable;
}

Rgb Parsed(const std::string& css) {
  Rgb colour;
  for (int k = 0; k < 3; ++k) {
    colour[k] = static_cast<float>(std::stoi(css.substr(1 + 2 * k, 2), nullptr, 16)) / 255.f;
  }
  return colour;
}

/// Something that stays lines, dots and words: in the SVG itself, painted into the PNG.
struct Mark {
  enum class Kind { kLine, kDot, kText, kBar } kind;
  Eigen::Vector2d at, to;
  double size;        ///< width of a line, diameter of a dot
  std::string paint;  ///< of a bar: its colour
  std::string text = {};
};

/// A map made ready to be drawn.
class Picture {
 public:
  Picture(const UvMap& map, const std::string& measure)
      : map_(map), measure_(*DistortionMeasures().Find(measure)), fit_(map) {
    const EdgeLengths lengths = MeasureEdgeLengths(map.surface);
    const MappedFaces faces = MeasureFaces(map.surface.triangulation, lengths, map.uv);
    ColourFaces(faces);
    AddEdges(map.boundary, "boundary", 0.7);
    AddEdges(map.seams, "seam", 1.1);
    AddCones();
    AddLegend(faces);
  }

  std::string Svg() const;
  std::string Png() const;

 private:
  void ColourFaces(const MappedFaces& faces) {
    const Eigen::VectorXd values = measure_.measure(faces).face_values;
    colour_.assign(map_.surface.triangulation.num_faces(), Rgb(0.5f, 0.5f, 0.5f));
    for (Index i = 0; i < faces.num_faces(); ++i) colour_[faces.face[i]] = At(values[i]);
  }

  Rgb At(double value) const {
    const Colour colour = ColourOnScale(value, measure_.least, measure_.greatest);
    return Rgb(static_cast<float>(colour[0]), static_cast<float>(colour[1]),
               static_cast<float>(colour[2])) /
           255.f;
  }

  /// Rounded, so that lines too short to be seen are dropped without a gap.
  void AddEdges(const std::vector<Index>& halfedges, const std::string& paint, double width) {
    if (map_.IsOnSphere()) return;
    std::set<std::array<double, 4>> seen;
    for (const Index h : halfedges) {
      const Eigen::Vector2d a = InPicture(map_.uv.value[Triangulation::Next(h)]);
      const Eigen::Vector2d b = InPicture(map_.uv.value[Triangulation::Prev(h)]);
      if (a == b || !seen.insert({a.x(), a.y(), b.x(), b.y()}).second) continue;
      marks_.push_back({Mark::Kind::kLine, a, b, width, paint});
    }
  }

  Eigen::Vector2d InPicture(const Eigen::Vector2d& uv) const {
    const Eigen::Vector2d at = fit_(uv) + Eigen::Vector2d(kSecond, kTop);
    return (at / kGrid).array().round() * kGrid;
  }

  void AddCones() {
    if (map_.cones.empty()) return;
    std::vector<double> sum(map_.surface.triangulation.num_vertices, 0);
    for (const auto& [vertex, angle] : map_.cones) sum[vertex] = angle;
    for (std::size_t p = 0; p < map_.point_vertex.size(); ++p) {
      const double angle = sum[map_.point_vertex[p]];
      if (angle != 0) AddCone(InPicture(map_.point_uv[p]), angle);
    }
  }

  void AddCone(const Eigen::Vector2d& at, double angle) {
    marks_.push_back({Mark::Kind::kDot, at, at, 7, "ring"});
    marks_.push_back({Mark::Kind::kDot, at, at, 5, angle < 2 * kPi ? "less" : "more"});
  }

  void AddText(double x, double y, const std::string& text, const std::string& paint = "ink") {
    marks_.push_back({Mark::Kind::kText, {x, y}, {x, y}, kFontSize, paint, text});
  }

  void AddLegend(const MappedFaces& faces) {
    const double first = kTop + kPanel + 20, second = first + 28, third = second + 28;
    AddText(kGap, first,
            map_.lattice ? "surface, with the lattice of its image"
                         : "surface, with the squares of its image");
    AddText(kSecond, first, map_.IsOnSphere() ? "image on the sphere, from both sides" : "image");
    AddText(kGap, third, Figures(faces), "quiet");
    AddSigns(second);
    const double bar = kSecond + 24;
    for (int i = 0; i < kStops; ++i) {
      const double t = static_cast<double>(i) / (kStops - 1);
      const Rgb c = 255 * At(measure_.least + t * (measure_.greatest - measure_.least));
      const double x = bar + kBarWidth * i / kStops;
      marks_.push_back({Mark::Kind::kBar,
                        {x, second - kBarHeight},
                        {x + kBarWidth / kStops + 0.2, second},
                        0,
                        fmt::format("#{:02x}{:02x}{:02x}", std::lround(c[0]), std::lround(c[1]),
                                    std::lround(c[2]))});
    }
    AddText(kSecond, second, fmt::format("{:g}", measure_.least), "quiet");
    AddText(bar + kBarWidth + 10, second, fmt::format("{:g}", measure_.greatest), "quiet");
    AddText(bar + kBarWidth + 40, second, measure_.face_meaning);
  }

  /// What the lines and dots are, of those that there are.
  void AddSigns(double y) {
    double x = kGap;
    const auto add = [&](const std::string& text) {
      AddText(x + 24, y, text);
      x += 24 + 1.1 * TextWidth(text, kStrokeSize) + 20;  // fonts differ
    };
    const double middle = y - 4;
    if (!map_.seams.empty()) {
      marks_.push_back({Mark::Kind::kLine, {x, middle}, {x + 16, middle}, 1.6, "seam"});
      add("seams");
    }
    const auto some = [&](bool less) {
      return std::any_of(map_.cones.begin(), map_.cones.end(),
                         [&](const auto& cone) { return (cone.second < 2 * kPi) == less; });
    };
    for (const bool less : {true, false}) {
      if (!some(less)) continue;
      AddCone({x + 10, middle}, less ? kPi : 3 * kPi);
      add(less ? "cones of less than 2 pi" : "cones of more");
    }
  }

  std::string Figures(const MappedFaces& faces) const {
    std::string text = Count(colour_.size(), "triangle");
    if (!map_.seams.empty()) text += ", " + Count(map_.seams.size() / 2, "seam edge");
    if (!map_.cones.empty()) text += ", " + Count(map_.cones.size(), "cone");
    if (faces.num_faces() == 0) return text;
    const Eigen::VectorXd ratio = faces.sigma_max.cwiseQuotient(faces.sigma_min);
    return text + fmt::format("; sigma_max / sigma_min: mean {:.4g}, largest {:.4g}",
                              AreaMean(faces.area, ratio), ratio.maxCoeff());
  }

  const UvMap& map_;
  DistortionMeasure measure_;
  PanelFit fit_;
  std::vector<Rgb> colour_;  ///< of each face
  std::vector<Mark> marks_;
};

/// Both themes, and what the marks are drawn with.
std::string StyleSheet() {
  std::string light, dark;
  for (const Paint& paint : Paints()) {
    light += fmt::format("--{}:{};", paint.name, paint.light);
    dark += fmt::format("--{}:{};", paint.name, paint.dark);
  }
  std::string text = "<style>svg{" + light + "}\n@media (prefers-color-scheme: dark){svg{" + dark +
                     "}}\npath{fill:none;stroke-linecap:round}\n"
                     "text{font:13px system-ui,sans-serif}\n";
  for (const Paint& paint : Paints()) {
    text +=
        fmt::format(".{0}{{fill:var(--{0})}}path.{0}{{stroke:var(--{0});fill:none}}\n", paint.name);
  }
  return text + "</style>\n";
}

std::string SvgImage(const RgbaImage& image, double x) {
  return fmt::format(
      "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" href=\"data:image/png;base64,{}\"/>\n",
      x, kTop, kPanel, kPanel, Base64(EncodePng(image)));
}

/// Lines of one kind that follow each other are one path.
std::string SvgMarks(const std::vector<Mark>& marks) {
  std::string text;
  const Mark* path = nullptr;
  for (const Mark& mark : marks) {
    const bool is_line = mark.kind == Mark::Kind::kLine;
    const bool goes_on = is_line && path && path->paint == mark.paint && path->size == mark.size;
    if (path && !goes_on) text += "\"/>\n";
    if (is_line && !goes_on) {
      text += fmt::format("<path class=\"{}\" stroke-width=\"{}\" d=\"", mark.paint, mark.size);
    }
    path = is_line ? &mark : nullptr;
    const double x = mark.at.x(), y = mark.at.y();
    if (is_line) {
      text += fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", x, y, mark.to.x(), mark.to.y());
    } else if (mark.kind == Mark::Kind::kDot) {
      text += fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>\n",
                          mark.paint, x, y, mark.size / 2);
    } else if (mark.kind == Mark::Kind::kText) {
      text += fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", mark.paint, x, y,
                          Escape(mark.text));
    } else {
      text += fmt::format(
          "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n", x,
          y, mark.to.x() - x, mark.to.y() - y, mark.paint);
    }
  }
  return text + (path ? "\"/>\n" : "");
}

std::string Picture::Svg() const {
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\">\n",
      kWidth, kHeight);
  svg += StyleSheet();
  svg += "<rect class=\"page\" width=\"100%\" height=\"100%\"/>\n";
  svg += SvgImage(SurfacePanel(map_, kSvgScale), kGap);
  svg += SvgImage(ImagePanel(map_, colour_, kSvgScale), kSecond);
  return svg + SvgMarks(marks_) + "</svg>\n";
}

Rgb LightPaint(const std::string& name) {
  for (const Paint& paint : Paints()) {
    if (paint.name == name) return Parsed(paint.light);
  }
  return Parsed(name);
}

void Draw(const Mark& mark, Raster* raster) {
  const Eigen::Vector2d at = kPngScale * mark.at, to = kPngScale * mark.to;
  const Rgb colour = LightPaint(mark.paint);
  if (mark.kind == Mark::Kind::kText) {
    DrawText(mark.text, at.x(), at.y(), kPngScale * kStrokeSize, colour, raster);
  } else if (mark.kind == Mark::Kind::kBar) {
    raster->Rectangle(at, to, colour);
  } else {
    raster->Line({at.x(), at.y(), 0}, {to.x(), to.y(), 0}, kPngScale * mark.size, colour);
  }
}

std::string Picture::Png() const {
  const auto pixels = [](double units) { return static_cast<int>(std::lround(kPngScale * units)); };
  RgbaImage page = {pixels(kWidth), pixels(kHeight), {}};
  page.rgba.assign(4 * static_cast<std::size_t>(page.width) * page.height, 255);
  Paste(SurfacePanel(map_, kPngScale), pixels(kGap), pixels(kTop), &page);
  Paste(ImagePanel(map_, colour_, kPngScale), pixels(kSecond), pixels(kTop), &page);
  Raster raster(page.width, page.height);
  for (const Mark& mark : marks_) Draw(mark, &raster);
  Paste(raster.Finish(), 0, 0, &page);
  return EncodePng(page);
}

}  // namespace

std::string PictureSvg(const UvMap& map, const std::string& measure) {
  return Picture(map, measure).Svg();
}

std::string PicturePng(const UvMap& map, const std::string& measure) {
  return Picture(map, measure).Png();
}

}  // namespace cirque

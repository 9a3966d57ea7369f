#include "experiments/circle_patterns/pictures.h"

#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/atomic_file.h"
#include "cirque/core/count.h"
#include "cirque/core/text.h"
#include "cirque/io/io.h"
#include "cirque/metrics/distortion_measure.h"

#include "experiments/common/map_view/picture.h"
#include "experiments/common/map_view/view_page.h"

namespace cirque {
namespace {

/// FILE and MEASURE of "FILE:MEASURE".
std::pair<std::string, std::string> PictureAndMeasure(const std::string& picture) {
  const std::size_t colon = picture.rfind(':');
  if (colon == std::string::npos || picture.find('/', colon) != std::string::npos) {
    return {picture, kPictureMeasure};
  }
  return {picture.substr(0, colon), picture.substr(colon + 1)};
}

std::vector<std::string> MeasuresOfFaces() {
  std::vector<std::string> names;
  for (const std::string& name : DistortionMeasures().Names()) {
    if (!DistortionMeasures().Find(name)->face_meaning.empty()) names.push_back(name);
  }
  return names;
}

/// "3 at 8 cones, 5 at 4 cones": how many of its sectors the pattern of a lattice has around cones.
std::string SectorsAtCones(const UvMap& map, int order) {
  std::map<long, int> cones_of;
  for (const auto& cone : map.cones) ++cones_of[std::lround(cone.second * order / (2 * kPi))];
  std::vector<std::string> texts;
  for (const auto& [sectors, cones] : cones_of) {
    texts.push_back(fmt::format("{} at {}", sectors, Count(cones, "cone")));
  }
  return Join(texts);
}

std::vector<std::pair<std::string, std::string>> Facts(const Certificate& c, const UvMap& map) {
  std::vector<std::pair<std::string, std::string>> facts = {{"outcome", c.outcome}};
  if (map.lattice) {
    const int order = OrderOf(*map.lattice);
    facts.emplace_back("lattice", fmt::format("{}; seams and cones off it by at most {:.2g} cells",
                                              order == 4 ? "squares" : "triangles",
                                              c.integers->integer_gap.value_or(0)));
    if (!map.cones.empty()) {
      facts.emplace_back(fmt::format("sectors of the pattern, {} in the plane", order),
                         SectorsAtCones(map, order));
    }
  }
  if (c.layout) {
    facts.emplace_back("flipped triangles", fmt::format("{}", c.layout->flipped_triangles));
    if (c.layout->cones) facts.emplace_back("cones", fmt::format("{}", *c.layout->cones));
  }
  if (!c.overlap.empty()) facts.emplace_back("overlap", c.overlap);
  if (c.distortion) {
    facts.emplace_back(
        "quasi-conformal distortion",
        fmt::format("mean {:.5f}, largest {:.4g}", c.distortion->quasi_conformal_mean,
                    c.distortion->quasi_conformal_max));
    facts.emplace_back("log area ratio",
                       fmt::format("{:.3f} to {:.3f}", c.distortion->log_area_ratio_min,
                                   c.distortion->log_area_ratio_max));
  }
  return facts;
}

Status WriteView(const std::string& path, const std::string& title, const UvMap& map,
                 const Certificate& certificate, std::ostream& report) {
  const Index faces = map.surface.triangulation.num_faces();
  if (faces > kMostViewedTriangles) {
    return Status::InvalidInput(
        fmt::format("--view: {} triangles are more than the {} of a page that browsers turn "
                    "smoothly; --picture "
                    "draws any number. The map itself is written",
                    faces, kMostViewedTriangles));
  }
  const Status written = WriteFileAtomically(path, ViewPage(title, map, Facts(certificate, map)));
  if (written.ok()) report << "view        " << path << "\n";
  return written;
}

}  // namespace

std::string PictureFile(const std::string& picture) { return PictureAndMeasure(picture).first; }

Status CheckPictures(const std::string& view, const std::string& picture) {
  const std::string page = MeshExtension(view);
  if (!view.empty() && page != "html" && page != "htm") {
    return Status::InvalidInput(view + ": a view is a page; name it .html");
  }
  if (picture.empty()) return Status();
  const auto [file, measure] = PictureAndMeasure(picture);
  const std::string kind = MeshExtension(file);
  if (kind != "svg" && kind != "png") {
    return Status::InvalidInput(file + ": pictures are .svg or .png; name it so");
  }
  for (const std::string& name : MeasuresOfFaces()) {
    if (name == measure) return Status();
  }
  return Status::InvalidInput(UnknownName("measure of a picture", measure, MeasuresOfFaces()));
}

Status WritePictures(const std::string& view, const std::string& picture, const std::string& title,
                     const UvMap& map, const Certificate& certificate, std::ostream& report) {
  if (!picture.empty()) {
    const auto [file, measure] = PictureAndMeasure(picture);
    const bool as_svg = MeshExtension(file) == "svg";
    const std::string bytes = as_svg ? PictureSvg(map, measure) : PicturePng(map, measure);
    if (Status s = WriteFileAtomically(file, bytes); !s.ok()) return s;
    report << "picture     " << file << "\n";
  }
  return view.empty() ? Status() : WriteView(view, title, map, certificate, report);
}

}  // namespace cirque

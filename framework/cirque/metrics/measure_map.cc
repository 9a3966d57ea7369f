#include "cirque/metrics/measure_map.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/core/text.h"
#include "cirque/metrics/registry.h"

namespace cirque {
namespace {

/// One value for each face of the triangulation.
Eigen::VectorXd Scatter(const MappedFaces& faces, const Eigen::VectorXd& measured) {
  CHECK_EQ(measured.size(), faces.num_faces());
  Eigen::VectorXd values = Eigen::VectorXd::Constant(faces.triangulation.num_faces(),
                                                     std::numeric_limits<double>::quiet_NaN());
  for (Index i = 0; i < faces.num_faces(); ++i) values[faces.face[i]] = measured[i];
  return values;
}

DistortionMeasure MeasureOf(const std::string& name) { return *DistortionMeasures().Find(name); }

bool Contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

double MapMeasures::ValueOf(const std::string& figure) const {
  const auto found = std::find_if(figures.begin(), figures.end(),
                                  [&](const Figure& f) { return f.name == figure; });
  CHECK(found != figures.end()) << figure;
  return found->value;
}

const MapMeasures::FaceValues& MapMeasures::FaceValuesOf(const std::string& metric) const {
  const auto found = std::find_if(faces.begin(), faces.end(),
                                  [&](const FaceValues& f) { return f.metric == metric; });
  CHECK(found != faces.end()) << metric;
  return *found;
}

MapMeasures MeasureMap(const Triangulation& t, const EdgeLengths& lengths, const CornerUv& uv,
                       const CornerAngles* angles) {
  const MappedFaces faces = MeasureFaces(t, lengths, uv, angles);
  MapMeasures measures;
  for (const std::string& name : DistortionMeasures().Names()) {
    const DistortionMeasure metric = MeasureOf(name);
    const Measurement found = metric.measure(faces);
    CHECK_EQ(found.figures.size(), metric.figures.size()) << name;
    for (std::size_t i = 0; i < found.figures.size(); ++i) {
      const FigureSpec& spec = metric.figures[i];
      measures.figures.push_back({metric.group, spec.name, spec.meaning, found.figures[i]});
    }
    if (metric.face_meaning.empty()) continue;
    measures.faces.push_back({name, metric.face_meaning, metric.least, metric.greatest,
                              Scatter(faces, found.face_values)});
  }
  return measures;
}

StatusOr<std::map<std::string, double>> MeasureFigures(const Triangulation& t,
                                                       const EdgeLengths& lengths,
                                                       const CornerUv& uv,
                                                       const std::vector<std::string>& names) {
  const std::vector<std::string> known = FigureNames();
  for (const std::string& name : names) {
    if (!Contains(known, name)) return Status::InvalidInput(UnknownName("measure", name, known));
  }
  const MappedFaces faces = MeasureFaces(t, lengths, uv);
  std::map<std::string, double> values;
  for (const std::string& measure_name : DistortionMeasures().Names()) {
    const DistortionMeasure metric = MeasureOf(measure_name);
    const bool wanted =
        std::any_of(metric.figures.begin(), metric.figures.end(),
                    [&](const FigureSpec& spec) { return Contains(names, spec.name); });
    if (!wanted) continue;
    const Measurement found = metric.measure(faces);
    for (std::size_t i = 0; i < found.figures.size(); ++i) {
      const std::string& name = metric.figures[i].name;
      if (Contains(names, name)) values[name] = found.figures[i];
    }
  }
  return values;
}

std::vector<std::string> FigureNames() {
  std::vector<std::string> names;
  for (const std::string& name : DistortionMeasures().Names()) {
    for (const FigureSpec& spec : MeasureOf(name).figures) names.push_back(spec.name);
  }
  return names;
}

std::string FormatFigures(const MapMeasures& measures) {
  std::size_t width = 0;
  for (const auto& figure : measures.figures) width = std::max(width, figure.name.size());
  std::string text;
  for (std::size_t i = 0; i < measures.figures.size(); ++i) {
    const MapMeasures::Figure& figure = measures.figures[i];
    const bool heads = i == 0 || figure.group != measures.figures[i - 1].group;
    if (heads) text += figure.group + "\n";
    text +=
        fmt::format("  {:<{}}  {:<11.6g}  {}\n", figure.name, width, figure.value, figure.meaning);
  }
  return text;
}

}  // namespace cirque

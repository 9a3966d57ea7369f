#include "cirque/metrics/measure_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/core/text.h"

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

const MapMeasures::FaceValues& MapMeasures::FaceValuesOf(const std::string& measure) const {
  const auto found = std::find_if(faces.begin(), faces.end(),
                                  [&](const FaceValues& f) { return f.measure == measure; });
  CHECK(found != faces.end()) << measure;
  return *found;
}

MapMeasures MeasureMap(const Triangulation& t, const EdgeLengths& lengths, const CornerUv& uv,
                       const CornerAngles* angles, const Registry<DistortionMeasure>& table) {
  const MappedFaces faces = MeasureFaces(t, lengths, uv, angles);
  MapMeasures measures;
  for (const std::string& name : table.Names()) {
    const DistortionMeasure measure = *table.Find(name);
    const Measurement found = measure.measure(faces);
    CHECK_EQ(found.figures.size(), measure.figures.size()) << name;
    for (std::size_t i = 0; i < found.figures.size(); ++i) {
      const FigureSpec& spec = measure.figures[i];
      measures.figures.push_back({measure.group, spec.name, spec.meaning, found.figures[i]});
    }
    if (measure.face_meaning.empty()) continue;
    measures.faces.push_back({name, measure.face_meaning, measure.least, measure.greatest,
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
    if (!Contains(known, name))
      return Status::InvalidInput(UnknownName("quality figure", name, known));
  }
  const MappedFaces faces = MeasureFaces(t, lengths, uv);
  std::map<std::string, double> values;
  for (const std::string& measure_name : DistortionMeasures().Names()) {
    const DistortionMeasure measure = MeasureOf(measure_name);
    const bool needed =
        std::any_of(measure.figures.begin(), measure.figures.end(),
                    [&](const FigureSpec& spec) { return Contains(names, spec.name); });
    if (!needed) continue;
    const Measurement found = measure.measure(faces);
    for (std::size_t i = 0; i < found.figures.size(); ++i) {
      const std::string& name = measure.figures[i].name;
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

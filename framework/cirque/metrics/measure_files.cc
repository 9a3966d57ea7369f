#include "cirque/metrics/measure_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cirque/core/atomic_file.h"
#include "cirque/core/text.h"
#include "cirque/io/text_writer.h"
#include "cirque/metrics/colour_scale.h"
#include "cirque/metrics/registry.h"

namespace cirque {
namespace {

constexpr char kDefaultColours[] = "quasi_conformal";

std::string Ending(const std::string& path) {
  return std::filesystem::path(path).extension().string();
}

std::vector<std::string> MeasuresWithFaceValues() {
  std::vector<std::string> names;
  for (const std::string& name : DistortionMeasures().Names()) {
    if (!DistortionMeasures().Find(name)->face_meaning.empty()) names.push_back(name);
  }
  return names;
}

StatusOr<MeasureFile> ParseMeasureFile(const std::string& word) {
  const std::size_t colon = word.rfind(".ply:");
  MeasureFile file{word, kDefaultColours};
  if (colon != std::string::npos) file = {word.substr(0, colon + 4), word.substr(colon + 5)};
  const std::string ending = Ending(file.path);
  if (ending != ".csv" && ending != ".json" && ending != ".ply") {
    return Status::InvalidInput(fmt::format(
        "'{}' as a file of measures: name it .csv (per face), .json (figures) or .ply (colours)",
        word));
  }
  const std::vector<std::string> known = MeasuresWithFaceValues();
  if (std::find(known.begin(), known.end(), file.colour_by) == known.end()) {
    return Status::InvalidInput(UnknownName("metric with face values", file.colour_by, known));
  }
  return file;
}

}  // namespace

StatusOr<std::vector<MeasureFile>> ParseMeasureFiles(const std::string& list) {
  std::vector<MeasureFile> files;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    StatusOr<MeasureFile> file = ParseMeasureFile(word);
    if (!file.ok()) return file.status();
    files.push_back(*std::move(file));
  }
  return files;
}

std::string MeasuresCsv(const MapMeasures& measures) {
  TextWriter out;
  out.Text("face");
  for (const auto& values : measures.faces) out.Text("," + values.metric);
  out.Text("\n");
  const Eigen::Index num_faces = measures.faces.empty() ? 0 : measures.faces.front().value.size();
  for (Eigen::Index f = 0; f < num_faces; ++f) {
    out.Number(f);
    for (const auto& values : measures.faces) {
      out.Text(",");
      if (!std::isnan(values.value[f])) out.Number(values.value[f]);
    }
    out.Text("\n");
  }
  return std::move(out).Take();
}

std::string MeasuresJson(const MapMeasures& measures) {
  nlohmann::ordered_json values = nlohmann::ordered_json::object(), meanings = values;
  for (const MapMeasures::Figure& figure : measures.figures) {
    values[figure.name] = figure.value;  // NaN is written as null
    meanings[figure.name] = figure.meaning;
  }
  return nlohmann::ordered_json{{"measures", values}, {"meanings", meanings}}.dump(1) + "\n";
}

std::string MeasuresPly(const std::vector<Eigen::Vector3d>& position,
                        const std::vector<Index>& corner, const MapMeasures& measures,
                        const std::string& colour_by) {
  const MapMeasures::FaceValues& values = measures.FaceValuesOf(colour_by);
  std::vector<Colour> colours;
  for (const double value : values.value) {
    colours.push_back(ColourOnScale(value, values.least, values.greatest));
  }
  const std::string range =
      fmt::format("colours: {} = {}, from {} ({}) to {} ({}), grey where degenerate", colour_by,
                  values.meaning, values.least, values.least < 0 ? "blue" : "dark blue",
                  values.greatest, values.least < 0 ? "red" : "light yellow");
  return FormatColouredPly(position, corner, colours, {range});
}

Status WriteMeasureFiles(const std::vector<MeasureFile>& files,
                         const std::vector<Eigen::Vector3d>& position,
                         const std::vector<Index>& corner, const MapMeasures& measures) {
  for (const MeasureFile& file : files) {
    const std::string ending = Ending(file.path);
    const std::string text = ending == ".csv" ? MeasuresCsv(measures)
                             : ending == ".json"
                                 ? MeasuresJson(measures)
                                 : MeasuresPly(position, corner, measures, file.colour_by);
    if (Status s = WriteFileAtomically(file.path, text); !s.ok()) return s;
  }
  return Status();
}

}  // namespace cirque

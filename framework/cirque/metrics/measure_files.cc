#include "cirque/metrics/measure_files.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cirque/core/atomic_file.h"
#include "cirque/core/text.h"
#include "cirque/io/text_writer.h"
#include "cirque/metrics/distortion_measure.h"

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
  static const std::vector<std::string> known = MeasuresWithFaceValues();
  if (std::find(known.begin(), known.end(), file.colour_by) == known.end()) {
    return Status::InvalidInput(
        UnknownName("distortion measure with face values", file.colour_by, known));
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
  for (const auto& values : measures.faces) out.Text("," + values.measure);
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

namespace {

using Table = std::array<Colour, 9>;

constexpr Colour kGrey = {128, 128, 128};

/// OKLab lightness 0.24 to 0.95, hue 300 to 105 degrees, chroma 0.13 or what sRGB has there.
constexpr Table kOneSidedTable = {{{43, 0, 81},
                                   {38, 40, 118},
                                   {4, 77, 139},
                                   {6, 111, 143},
                                   {8, 144, 153},
                                   {7, 178, 154},
                                   {108, 205, 142},
                                   {182, 226, 133},
                                   {251, 244, 136}}};

/// OKLab lightness 0.4, 0.95, 0.4, hue 255 and 35 degrees, chroma growing to 0.17.
constexpr Table kTwoSidedTable = {{{1, 70, 140},
                                   {48, 110, 186},
                                   {109, 153, 210},
                                   {170, 196, 230},
                                   {238, 238, 238},
                                   {227, 182, 170},
                                   {203, 128, 109},
                                   {174, 75, 51},
                                   {130, 30, 1}}};

}  // namespace

Colour ColourOnScale(double value, double least, double greatest) {
  if (std::isnan(value)) return kGrey;
  const Table& table = least < 0 && greatest > 0 ? kTwoSidedTable : kOneSidedTable;
  const double share = std::clamp((value - least) / (greatest - least), 0.0, 1.0);
  const double step = share * static_cast<double>(table.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(step), table.size() - 2);
  const double weight = step - static_cast<double>(below);
  Colour colour;
  for (std::size_t i = 0; i < 3; ++i) {
    colour[i] = static_cast<int>(
        std::lround((1 - weight) * table[below][i] + weight * table[below + 1][i]));
  }
  return colour;
}

}  // namespace cirque

// Values and textures of one map of a surface for another map of it.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/atomic_file.h"
#include "cirque/core/count.h"
#include "cirque/core/text.h"
#include "cirque/domains/transfer.h"
#include "cirque/io/image.h"

#include "experiments/common/flag_parsing.h"
#include "experiments/common/manual.h"
#include "experiments/common/program.h"
#include "experiments/transfer/map_file.h"
#include "experiments/transfer/move_values.h"

DEFINE_string(values, "",
              "IN is no picture but a table, a line of numbers for each of FROM's 'vertices' or "
              "'faces', and OUT one of TO's");
DEFINE_string(frame, "unit",
              "what the pictures cover: the 'unit' square, or the 'box' of each map");
DEFINE_int32(width, 0, "columns of the picture written; 0: as the one read");
DEFINE_int32(height, 0, "rows of the picture written; 0: as the one read");
DEFINE_int32(margin, 4, "texels around the image that are filled, so that seams show none without");

namespace cirque {
namespace {

constexpr char kSource[] = "experiments/transfer/";
constexpr int kDone = 0, kBadInput = 2;
constexpr double kRounding = 1e-9;  ///< by which a map may leave the unit square
constexpr int kMostSide = 1 << 15;

Manual ProgramManual() {
  return {
      "transfer",
      "moves a texture or values from one map of a mesh to another",
      {{"MESH FROM TO IN OUT", "the picture IN painted for the map FROM, as OUT for the map TO"},
       {"--values=vertices MESH FROM TO IN OUT", "a table of values instead"}},
      {"FROM and TO are maps of MESH as circle_patterns writes them, with its --uv=unit for "
       "pictures over the unit square; each may be an .obj of --exact. Pictures are .png, .pgm "
       "or .ppm. Texels outside the image and its margin are 0."},
      {{"0", "done"}, {"2", "bad input"}}};
}

int Complain(const Status& status) {
  fmt::print(stderr, "transfer: {}\n", status.message());
  return kBadInput;
}

struct Files {
  std::string mesh, from, to, in, out;
};

/// What both pictures and tables need.
struct Maps {
  MeshOfMaps of;
  MapFile from, to;
};

StatusOr<Maps> ReadMaps(const Files& files) {
  StatusOr<MeshOfMaps> of = ReadSurface(files.mesh);
  if (!of.ok()) return of.status();
  StatusOr<MapFile> from = ReadMap(files.from, *of), to = ReadMap(files.to, *of);
  if (!from.ok()) return from.status();
  if (!to.ok()) return to.status();
  return Maps{*std::move(of), *std::move(from), *std::move(to)};
}

StatusOr<Eigen::AlignedBox2d> FrameOf(const std::string& path, const MapLocator& map) {
  if (FLAGS_frame == "box") return map.box();
  const Eigen::AlignedBox2d unit(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1));
  if (map.box().min().minCoeff() >= -kRounding && map.box().max().maxCoeff() <= 1 + kRounding) {
    return unit;
  }
  return Status::InvalidInput(
      path +
      ": the map leaves the unit square; write it by circle_patterns --uv=unit, or give "
      "--frame=box");
}

Texture TextureOf(const Image& image, const Eigen::AlignedBox2d& frame) {
  Texture texture{image.width, image.height, image.channels, frame, {}};
  const std::size_t row = static_cast<std::size_t>(image.width) * image.channels;
  for (int j = image.height - 1; j >= 0; --j) {
    const auto begin = image.sample.begin() + static_cast<std::ptrdiff_t>(j * row);
    texture.value.insert(texture.value.end(), begin, begin + static_cast<std::ptrdiff_t>(row));
  }
  return texture;
}

Image ImageOf(const Texture& texture, int most) {
  Image image{texture.width, texture.height, texture.channels, most, {}};
  const int row = texture.width * texture.channels;
  for (int j = texture.height - 1; j >= 0; --j) {
    const double* value = texture.At(0, j);
    for (int i = 0; i < row; ++i) {
      image.sample.push_back(
          static_cast<std::uint16_t>(std::clamp(std::rint(value[i]), 0., 1. * most)));
    }
  }
  return image;
}

Status MovePicture(const Files& files) {
  const StatusOr<Image> image = ReadImage(files.in);
  if (!image.ok()) return image.status();
  const StatusOr<Maps> maps = ReadMaps(files);
  if (!maps.ok()) return maps.status();
  const MapLocator from(maps->from.triangles), to(maps->to.triangles);
  const auto frame = FrameOf(files.from, from), frame_of_to = FrameOf(files.to, to);
  if (!frame.ok()) return frame.status();
  if (!frame_of_to.ok()) return frame_of_to.status();
  Texture moved{FLAGS_width > 0 ? FLAGS_width : image->width,
                FLAGS_height > 0 ? FLAGS_height : image->height,
                image->channels,
                *frame_of_to,
                {}};
  TransferTexture(from, TextureOf(*image, *frame), to, FLAGS_margin, &moved);
  return WriteImage(files.out, ImageOf(moved, image->most));
}

Status MoveTable(const Files& files) {
  const StatusOr<Eigen::MatrixXd> values = ReadValues(files.in);
  if (!values.ok()) return values.status();
  const StatusOr<Maps> maps = ReadMaps(files);
  if (!maps.ok()) return maps.status();
  const PolygonSoup& mesh = maps->from.mesh;
  const bool of_vertices = FLAGS_values == "vertices";
  const auto expected = of_vertices ? static_cast<Eigen::Index>(mesh.position.size())
                                    : static_cast<Eigen::Index>(mesh.num_polygons());
  if (values->rows() != expected) {
    return Status::InvalidInput(fmt::format("{}: {} rows; {} has {} {}", files.in, values->rows(),
                                            files.from, expected, FLAGS_values));
  }
  return WriteValues(files.out, of_vertices
                                    ? MoveVertexValues(maps->from, *values, maps->to)
                                    : MoveFaceValues(maps->of, maps->from, *values, maps->to));
}

Status CheckFlags() {
  const std::vector<std::string> values = {"vertices", "faces"}, frames = {"unit", "box"};
  if (!FLAGS_values.empty() &&
      std::find(values.begin(), values.end(), FLAGS_values) == values.end())
    return Status::InvalidInput(UnknownName("kind of values", FLAGS_values, values));
  if (std::find(frames.begin(), frames.end(), FLAGS_frame) == frames.end())
    return Status::InvalidInput(UnknownName("frame", FLAGS_frame, frames));
  for (const auto& [name, number] :
       {std::pair("width", FLAGS_width), std::pair("height", FLAGS_height),
        std::pair("margin", FLAGS_margin)}) {
    if (number >= 0 && number <= kMostSide) continue;
    return Status::InvalidInput(
        fmt::format("--{} = {}: a number from 0 to {} is needed", name, number, kMostSide));
  }
  return Status();
}

int Main(int argc, char** argv) {
  CommandLine line = GflagsOf(kSource);
  const StatusOr<std::vector<std::string>> given = line.Parse({argv + 1, argv + argc});
  if (!given.ok()) return Complain(given.status());
  if (const auto answered = AnswerQuestions(ProgramManual(), line, *given)) return *answered;
  if (given->size() != 5) {
    return Complain(Status::InvalidInput(
        fmt::format("{} given; write transfer MESH FROM TO IN OUT", Count(given->size(), "file"))));
  }
  const Files files = {(*given)[0], (*given)[1], (*given)[2], (*given)[3], (*given)[4]};
  Status status = CheckFlags();
  if (status.ok()) status = CheckOutputPath(files.out);
  if (status.ok()) status = FLAGS_values.empty() ? MovePicture(files) : MoveTable(files);
  return status.ok() ? kDone : Complain(status);
}

}  // namespace
}  // namespace cirque

int main(int argc, char** argv) { return cirque::RunMain("transfer", argc, argv, cirque::Main); }

#include "cirque/io/io.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "cirque/core/registry.h"
#include "cirque/core/text.h"
#include "cirque/io/file_input.h"
#include "cirque/io/mesh_formats.h"

namespace cirque {
namespace {

struct MeshFormat {
  StatusOr<PolygonSoup> (*parse)(const std::string& path, std::string_view content);
  TextPieces (*format)(const PolygonSoup& mesh);  ///< null: only read
  bool holds_texture;                             ///< whether `format` writes UVs
};

const Registry<MeshFormat>& MeshFormats() {
  static const Registry<MeshFormat> formats("mesh format",
                                            {
                                                {"obj", {ParseObj, FormatObj, true}},
                                                {"off", {ParseOff, FormatOff, false}},
                                                {"ply", {ParsePly, FormatPly, false}},
                                                {"stl", {ParseStl, nullptr, false}},
                                            });
  return formats;
}

template <class Point>
Status CheckFinite(const char* kind, const std::vector<Point>& points) {
  const auto bad =
      std::find_if(points.begin(), points.end(), [](const auto& p) { return !p.allFinite(); });
  if (bad == points.end()) return Status();
  return Status::InvalidInput(
      fmt::format("{} {} (counted from 1) is not finite; no such mesh is written", kind,
                  bad - points.begin() + 1));
}

Status CheckHolds(const MeshFormat& format, const PolygonSoup& mesh) {
  if (!format.format || (!mesh.texture.empty() && !format.holds_texture)) {
    return Status::InvalidInput(fmt::format("this format cannot hold {}; write one of: {}",
                                            format.format ? "UVs" : "the mesh exactly",
                                            format.format ? "obj" : Join(WritableExtensions())));
  }
  const Status status = CheckFinite("vertex", mesh.position);
  return status.ok() ? CheckFinite("texture coordinate", mesh.texture) : status;
}

}  // namespace

std::string MeshExtension(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos && path.starts_with("/dev/")) return "obj";
  std::string extension = dot == std::string::npos ? "" : name.substr(dot + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

StatusOr<PolygonSoup> ReadMesh(const std::string& path) {
  // A name of no format is refused before a large file is read.
  const StatusOr<MeshFormat> format = MeshFormats().Find(MeshExtension(path));
  if (!format.ok()) return format.status().In(path);
  const StatusOr<std::string> content = ReadFileContent(path);
  return content.ok() ? ParseMesh(path, *content) : content.status();
}

StatusOr<PolygonSoup> ParseMesh(const std::string& path, std::string_view content) {
  const StatusOr<MeshFormat> format = MeshFormats().Find(MeshExtension(path));
  if (!format.ok()) return format.status().In(path);
  StatusOr<PolygonSoup> soup = format->parse(path, content);
  constexpr std::size_t kMost = std::numeric_limits<Index>::max();
  if (soup.ok() && (soup->corner.size() > kMost || soup->position.size() > kMost)) {
    return Status::InvalidInput(
        fmt::format("{}: more than {} corners or vertices; split the mesh", path, kMost));
  }
  return soup;
}

StatusOr<TextPieces> FormatMesh(const std::string& path, const PolygonSoup& mesh) {
  const StatusOr<MeshFormat> format = MeshFormats().Find(MeshExtension(path));
  if (!format.ok()) return format.status().In(path);
  const Status status = CheckHolds(*format, mesh);
  return status.ok() ? StatusOr<TextPieces>(format->format(mesh)) : status.In(path);
}

Status WriteMesh(const std::string& path, const PolygonSoup& mesh) {
  const StatusOr<TextPieces> content = FormatMesh(path, mesh);
  return content.ok() ? WriteFileAtomically(path, *content) : content.status();
}

std::vector<std::string> ReadableExtensions() { return MeshFormats().Names(); }

std::vector<std::string> WritableExtensions() {
  std::vector<std::string> writable;
  for (const std::string& name : MeshFormats().Names()) {
    if ((*MeshFormats().Find(name)).format) writable.push_back(name);
  }
  return writable;
}

}  // namespace cirque

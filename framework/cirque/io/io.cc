#include "cirque/io/io.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/registry.h"
#include "cirque/core/text.h"
#include "cirque/io/file_input.h"
#include "cirque/io/mesh_formats.h"
#include "cirque/io/unpack.h"

namespace cirque {
namespace {

struct MeshFormat {
  StatusOr<PolygonSoup> (*parse)(const std::string& path, std::string_view content);  ///< or null
  TextPieces (*format)(const PolygonSoup& mesh);                                      ///< or null
  /// Null for the formats that hold every mesh exactly; else why one cannot be held at all.
  std::string (*problem)(const PolygonSoup& mesh);
};

const Registry<MeshFormat>& MeshFormats() {
  static const Registry<MeshFormat> formats("mesh format",
                                            {
                                                {"obj", {ParseObj, FormatObj, nullptr}},
                                                {"off", {ParseOff, FormatOff, nullptr}},
                                                {"ply", {ParsePly, FormatPly, nullptr}},
                                                {"stl", {ParseStl, nullptr, nullptr}},
                                                {"om", {ParseOm, nullptr, nullptr}},
                                                {"glb", {nullptr, FormatGlb, ProblemAsGlb}},
                                            });
  return formats;
}

template <class Is>
std::vector<std::string> ExtensionsThat(const Is& is) {
  std::vector<std::string> extensions;
  for (const std::string& name : MeshFormats().Names()) {
    if (is(*MeshFormats().Find(name))) extensions.push_back(name);
  }
  return extensions;
}

std::string Lower(std::string_view word) {
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

/// Whether a word is one that begins a line of an obj, and may begin the file.
bool IsObjWord(std::string_view word) {
  constexpr std::string_view kWords[] = {"v", "vt", "vn", "vp",     "f",      "g",
                                         "o", "s",  "l",  "mtllib", "usemtl", "p"};
  return std::find(std::begin(kWords), std::end(kWords), word) != std::end(kWords);
}

/// The format that the first words tell, where they do.
std::optional<std::string> FormatOfContent(std::string_view content) {
  if (IsBinaryStl(content)) return "stl";
  if (IsOm(content)) return "om";
  constexpr std::size_t kLookedAt = 4096;  // comments at the beginning may be long
  TextScanner scanner("", content.substr(0, kLookedAt));
  if (!scanner.NextLine()) return std::nullopt;
  const std::string_view word = scanner.Word();
  if (word == "ply" && scanner.AtLineEnd()) return "ply";
  constexpr std::size_t kLongestOff = 9;  // STCN4nOFF
  const std::size_t off = word.find("OFF");
  if (off <= kLongestOff - 3 && word.substr(0, off).find_first_not_of("STCN4n") == word.npos) {
    return "off";
  }
  if (Lower(word) == "solid" && scanner.NextLine()) {
    const std::string second = Lower(scanner.Word());
    if (second == "facet" || second == "endsolid" || second == "end") return "stl";
  }
  return IsObjWord(word) ? std::optional<std::string>("obj") : std::nullopt;
}

/// The name without what says that it is packed.
std::string NameUnpacked(const std::string& path) {
  return Lower(path).ends_with(".gz") ? path.substr(0, path.size() - 3) : path;
}

/// The format of a file to read, with a warning where its name tells another.
StatusOr<std::string> FormatToRead(const std::string& path, std::string_view content,
                                   std::vector<std::string>* warnings) {
  const std::string named = MeshExtension(NameUnpacked(path));
  const std::optional<std::string> found = FormatOfContent(content);
  const std::vector<std::string> known = ReadableExtensions();
  const bool is_known = std::find(known.begin(), known.end(), named) != known.end();
  if (found && is_known && *found != named && path != "-" && !path.starts_with("/dev/")) {
    warnings->push_back(fmt::format("{}: this is {}, whatever its name says", path, *found));
  }
  if (found) return *found;
  if (is_known) return named;
  return Status::InvalidInput(UnknownName("mesh format", named, known) +
                              ", and the content is plainly none of them");
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
  if (!format.format) {
    return Status::InvalidInput("this format cannot hold the mesh exactly; write one of: " +
                                Join(MapExtensions()));
  }
  Status status = CheckFinite("vertex", mesh.position);
  if (status.ok()) status = CheckFinite("texture coordinate", mesh.texture);
  if (!status.ok() || !format.problem) return status;
  const std::string problem = format.problem(mesh);
  return problem.empty() ? status : Status::InvalidInput("the mesh " + problem);
}

/// The same, where the file is read in any case.
StatusOr<PolygonSoup> Parse(const std::string& path, std::string_view content,
                            std::vector<std::string> warnings, std::string* format) {
  const StatusOr<std::string> found = FormatToRead(path, content, &warnings);
  if (!found.ok()) return found.status().In(path);
  *format = *found;
  StatusOr<PolygonSoup> soup = (*MeshFormats().Find(*found)).parse(path, content);
  if (!soup.ok()) return soup;
  constexpr std::size_t kMost = std::numeric_limits<Index>::max();
  if (soup->corner.size() > kMost || soup->position.size() > kMost) {
    return Status::InvalidInput(
        fmt::format("{}: more than {} corners or vertices; split the mesh", path, kMost));
  }
  soup->warnings.insert(soup->warnings.begin(), warnings.begin(), warnings.end());
  return soup;
}

}  // namespace

std::string MeshExtension(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos && (path.starts_with("/dev/") || path == "-")) return "obj";
  return dot == std::string::npos ? "" : Lower(name.substr(dot + 1));
}

StatusOr<PolygonSoup> ReadMesh(const std::string& path) {
  StatusOr<MeshFile> file = ReadMeshFile(path);
  if (!file.ok()) return file.status();
  return std::move(file->soup);
}

StatusOr<MeshFile> ReadMeshFile(const std::string& path) {
  std::vector<std::string> warnings;
  StatusOr<std::string> content = ReadUnpacked(path, &warnings);
  if (!content.ok()) return content.status();
  std::string format;
  StatusOr<PolygonSoup> soup = Parse(path, *content, std::move(warnings), &format);
  if (!soup.ok()) return soup.status();
  return MeshFile{*std::move(soup), format == "obj" ? *std::move(content) : std::string()};
}

StatusOr<PolygonSoup> ParseMesh(const std::string& path, std::string_view content) {
  std::string format;
  return Parse(path, content, {}, &format);
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

Status WriteMeshInGroups(const std::string& path, const PolygonSoup& mesh,
                         const std::vector<Index>& group) {
  if (MeshExtension(path) != "obj") return WriteMesh(path, mesh);
  const StatusOr<TextPieces> content = FormatMesh(path, mesh);
  if (!content.ok()) return content.status();
  return WriteFileAtomically(path, FormatObjInGroups(mesh, group));
}

Status WriteHomogeneousObj(const std::string& path, const PolygonSoup& mesh,
                           const std::vector<Eigen::Vector3d>& texture,
                           const std::vector<Index>& group) {
  if (Status s = CheckFinite("coordinate", mesh.position); !s.ok()) return s.In(path);
  if (Status s = CheckFinite("texture coordinate", texture); !s.ok()) return s.In(path);
  return WriteFileAtomically(path, FormatHomogeneousObj(mesh, texture, group));
}

Status WriteLatticeGlb(const std::string& path, const PolygonSoup& mesh,
                       const LatticeTexture& lattice) {
  const Status status = CheckHolds(*MeshFormats().Find("glb"), mesh);
  return status.ok() ? WriteFileAtomically(path, FormatLatticeGlb(mesh, lattice)) : status.In(path);
}

Status WriteTexturedMesh(const std::string& path, const MeshFile& source,
                         const PolygonSoup& textured) {
  const bool is_same = textured.first_corner == source.soup.first_corner &&
                       textured.corner == source.soup.corner && !textured.corner_texture.empty();
  if (source.text.empty() || MeshExtension(path) != "obj" || !is_same) {
    return WriteMesh(path, textured);
  }
  if (Status s = CheckFinite("texture coordinate", textured.texture); !s.ok()) return s.In(path);
  return WriteFileAtomically(path, RewriteObj(source.text, textured));
}

std::vector<std::string> ReadableExtensions() {
  return ExtensionsThat([](const MeshFormat& format) { return format.parse != nullptr; });
}

std::vector<std::string> WritableExtensions() {
  return ExtensionsThat([](const MeshFormat& f) { return f.format && !f.problem; });
}

std::vector<std::string> MapExtensions() {
  return ExtensionsThat([](const MeshFormat& format) { return format.format != nullptr; });
}

}  // namespace cirque

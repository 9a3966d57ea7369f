#include "experiments/run_experiment/run/mesh_files.h"

#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/atomic_file.h"

#include "experiments/run_experiment/config/file_content.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;

/// The archive's size and time are part of the name, so that a newer archive is read again.
std::string CachePath(const MeshSpec& mesh, const std::string& cache) {
  const std::string state =
      fmt::format("{} {} {}", mesh.Source(), fs::file_size(mesh.archive),
                  fs::last_write_time(mesh.archive).time_since_epoch().count());
  const fs::path member = fs::path(mesh.member).filename();
  return (fs::path(cache) /
          (member.stem().string() + "-" + HashOf(state) + member.extension().string()))
      .string();
}

StatusOr<std::string> Extract(const MeshSpec& mesh, const std::string& cache) {
  std::string path = CachePath(mesh, cache);
  if (fs::exists(path)) return path;
  const StatusOr<std::string> content = ReadArchiveMember(mesh.archive, mesh.member);
  if (!content.ok()) return content.status();
  fs::create_directories(cache);
  if (Status status = WriteFileAtomically(path, *content); !status.ok()) return status;
  return path;
}

Status ExtractFrom(const std::string& archive, const std::map<std::string, std::string>& paths,
                   const std::string& cache) {
  std::set<std::string> members;
  for (const auto& [member, path] : paths) members.insert(member);
  fs::create_directories(cache);
  return ReadArchiveMembers(archive, members,
                            [&](const std::string& member, const std::string& content) {
                              return WriteFileAtomically(paths.at(member), content);
                            });
}

}  // namespace

Status ExtractMembers(const std::vector<MeshSpec>& meshes, const std::string& cache) {
  try {
    std::map<std::string, std::map<std::string, std::string>> missing;
    for (const MeshSpec& mesh : meshes) {
      if (mesh.archive.empty()) continue;
      std::string path = CachePath(mesh, cache);
      if (!fs::exists(path)) missing[mesh.archive][mesh.member] = std::move(path);
    }
    for (const auto& [archive, paths] : missing) {
      if (Status status = ExtractFrom(archive, paths, cache); !status.ok()) return status;
    }
  } catch (const fs::filesystem_error& error) {
    return Status::InvalidInput(error.what());
  }
  return Status();
}

StatusOr<LocatedMesh> LocateMesh(const MeshSpec& mesh, const std::string& cache) {
  if (!mesh.generator.empty()) return LocatedMesh{"", HashOf(mesh.Source())};
  try {
    const StatusOr<std::string> path =
        mesh.archive.empty() ? StatusOr<std::string>(mesh.file) : Extract(mesh, cache);
    if (!path.ok()) return path.status();
    const StatusOr<std::string> content = ReadWholeFile(*path);
    if (!content.ok()) return content.status();
    return LocatedMesh{*path, HashOf(*content)};
  } catch (const fs::filesystem_error& error) {
    return Status::InvalidInput(error.what());
  }
}

}  // namespace cirque

#include <exception>
#include <optional>
#include <stdexcept>

#include "cirque/io/json_input.h"

#include "experiments/run_experiment/run/ready_run.h"

namespace cirque {
namespace {

// CBOR rather than JSON text: file names need not be UTF-8. Every member is bound by name, so that
// one more does not compile until it is sent along.

nlohmann::json MeshToJson(const MeshSpec& mesh) {
  const auto& [name, file, archive, member, generator, options, known_boundary, family,
               subdivisions, subdivision, decimate, repair] = mesh;
  const auto& [triangles, seed] = options;
  return {{"name", name},
          {"file", file},
          {"archive", archive},
          {"member", member},
          {"generator", generator},
          {"triangles", triangles},
          {"seed", seed},
          {"known_boundary", known_boundary},
          {"family", family},
          {"subdivisions", subdivisions},
          {"subdivision", subdivision},
          {"decimate", decimate},
          {"repair", repair}};
}

MeshSpec MeshFromJson(const nlohmann::json& json) {
  return {json.at("name"),           json.at("file"),      json.at("archive"),
          json.at("member"),         json.at("generator"), {json.at("triangles"), json.at("seed")},
          json.at("known_boundary"), json.at("family"),    json.at("subdivisions"),
          json.at("subdivision"),    json.at("decimate"),  json.at("repair")};
}

MethodSpec MethodFromJson(const nlohmann::json& json) {
  MethodSpec method;
  method.name = json.at("name");
  if (json.contains("peer")) {
    method.peer = json["peer"];
    return method;
  }
  if (json.contains("energy")) {
    method.trial = {json["energy"], json.at("energy_solver"), json.at("energy_start")};
    method.options.epsilon = json.at("epsilon");
    return method;
  }
  method.domain = json.at("domain");
  method.options.exact = json.value("exact", false);
  for (const auto& option : ParameterizeOptionTable().options()) {
    const nlohmann::json& value = json.at(option.info().name);
    const Status status =
        option.Set(value.is_string() ? value.get<std::string>() : value.dump(), &method.options);
    if (!status.ok()) throw std::invalid_argument(status.message());
  }
  return method;
}

nlohmann::json RunToJson(const PlannedRun& run) {
  const auto& [mesh, method, repeat, measures, limits, keep_map, reference, against_refined] = run;
  const auto& [seconds, memory_mib] = limits;
  return {{"mesh", MeshToJson(mesh)},
          {"method", MethodJson(method)},
          {"repeat", repeat},
          {"measures", measures},
          {"seconds", seconds},
          {"memory_mib", memory_mib},
          {"keep_map", keep_map},
          {"reference", reference},
          {"against_refined", against_refined}};
}

PlannedRun RunFromJson(const nlohmann::json& json) {
  return {MeshFromJson(json.at("mesh")),
          MethodFromJson(json.at("method")),
          json.at("repeat"),
          json.at("measures"),
          {json.at("seconds"), json.at("memory_mib")},
          json.at("keep_map"),
          json.at("reference"),
          json.at("against_refined")};
}

}  // namespace

std::string PackRun(const ReadyRun& ready) {
  const nlohmann::json json = {{"key", ready.key},        {"run", RunToJson(ready.run)},
                               {"path", ready.mesh.path}, {"hash", ready.mesh.hash},
                               {"folder", ready.folder},  {"provenance", ready.provenance}};
  std::string bytes;
  nlohmann::json::to_cbor(json, bytes);
  return bytes;
}

StatusOr<ReadyRun> UnpackRun(const std::string& bytes) {
  try {
    const std::optional<nlohmann::json> parsed = ParseCbor(bytes);
    if (!parsed) throw std::invalid_argument("malformed CBOR");
    const nlohmann::json& json = *parsed;
    return ReadyRun{json.at("key"),
                    RunFromJson(json.at("run")),
                    {json.at("path"), json.at("hash")},
                    json.at("folder"),
                    json.at("provenance")};
  } catch (const std::exception& error) {
    return Status::InvalidInput(std::string("not a packed run of run_experiment: ") + error.what());
  }
}

}  // namespace cirque

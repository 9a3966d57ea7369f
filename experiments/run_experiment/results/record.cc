#include "experiments/run_experiment/results/record.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include "cirque/core/status.h"
#include "cirque/pipeline/certificate.h"

#include "experiments/common/records.h"
#include "experiments/run_experiment/config/file_content.h"
#include "experiments/run_experiment/config/method_files.h"

namespace cirque {
namespace {

nlohmann::json NumbersJson(const std::map<std::string, double>& numbers) {
  nlohmann::json json = nlohmann::json::object();
  for (const auto& [name, value] : numbers) {
    json[name] = std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
  }
  return json;
}

nlohmann::json NumbersJson(const std::vector<double>& numbers) {
  nlohmann::json json = nlohmann::json::array();
  for (const double number : numbers) {
    json.push_back(std::isfinite(number) ? nlohmann::json(number) : nlohmann::json());
  }
  return json;
}

/// The numbers of the certificate and the other figures.
std::map<std::string, double> ValuesOf(const RunResult& result) {
  std::map<std::string, double> values = NumbersOf(result.certificate);
  values.insert(result.figures.begin(), result.figures.end());
  return values;
}

/// Only the limits there are.
nlohmann::json LimitsJson(const RunLimits& limits) {
  nlohmann::json json = nlohmann::json::object();
  if (limits.seconds > 0) json["seconds"] = limits.seconds;
  if (limits.memory_mib > 0) json["memory_mib"] = limits.memory_mib;
  return json;
}

/// Whether a limit is higher than the one that the record tells of; 0 is none.
bool IsRaised(const Record& record, const char* name, double limit) {
  return limit == 0 || !(limit <= NumberAt(record, std::string("/limits/") + name));
}

StatusOr<std::string> HashOfFile(const std::string& path) {
  const StatusOr<std::string> content = ReadWholeFile(path);
  return content.ok() ? StatusOr<std::string>(HashOf(*content)) : content.status();
}

}  // namespace

nlohmann::json MethodJson(const MethodSpec& method) {
  nlohmann::json json = {{"name", method.name}};
  if (!method.peer.empty()) {
    json["peer"] = method.peer;
    return json;
  }
  if (method.trial.IsAskedFor()) {
    const auto& [energy, solver, start] = method.trial;
    json.update({{"energy", energy},
                 {"energy_solver", solver},
                 {"energy_start", start},
                 {"epsilon", method.options.epsilon}});
    return json;
  }
  json["domain"] = method.domain;
  for (const auto& option : ParameterizeOptionTable().options()) {
    json[option.info().name] = std::visit([](const auto& value) { return nlohmann::json(value); },
                                          option.Get(method.options));
  }
  if (method.options.exact) json["exact"] = true;
  return json;
}

std::string RunKey(const PlannedRun& run, const std::string& mesh_hash,
                   const nlohmann::json& method, const std::string& code_version) {
  nlohmann::json determined_by = {{"mesh", run.mesh.name},
                                  {"mesh_hash", mesh_hash},
                                  {"method", method},
                                  {"repeat", run.repeat},
                                  {"code", code_version}};
  if (!run.measures.empty()) determined_by["measures"] = run.measures;
  if (run.mesh.subdivisions > 0) determined_by["subdivisions"] = run.mesh.subdivisions;
  if (run.mesh.subdivision != MeshSpec().subdivision) {
    determined_by["subdivision"] = run.mesh.subdivision;
  }
  if (run.mesh.decimate > 0) determined_by["decimate"] = run.mesh.decimate;
  if (run.mesh.repair != MeshSpec().repair) determined_by["repair"] = run.mesh.repair;
  if (run.reference) determined_by["reference"] = true;
  if (run.against_refined) determined_by["against_refined"] = true;
  return HashOf(ToLine(determined_by));
}

Record MakeRecord(const std::string& key, const PlannedRun& run, const LocatedMesh& mesh,
                  const RunResult& result, const nlohmann::json& provenance) {
  Record record = {
      {"key", key},
      {"mesh",
       {{"name", run.mesh.name},
        {"family", run.mesh.family},
        {"source", run.mesh.Source()},
        {"hash", mesh.hash},
        {"vertices", result.vertices},
        {"triangles", result.triangles}}},
      {"method", MethodJson(run.method)},
      {"repeat", run.repeat},
      {"outcome", result.certificate.outcome},
      {"message", result.certificate.message},
      {"overlap", result.certificate.overlap},
      {"values", NumbersJson(ValuesOf(result))},
      {"seconds", NumbersJson(SecondsOf(result.certificate))},
      {"provenance", provenance},
  };
  if (!run.measures.empty()) record["measures"] = run.measures;
  if (result.cpu_seconds > 0) {
    record["cpu_seconds"] = result.cpu_seconds;
    record["map_cpu_seconds"] = result.map_cpu_seconds;
  }
  if (result.peak_memory_mib > 0) record["peak_memory_mib"] = result.peak_memory_mib;
  if (run.reference && result.reference.seconds > 0) {
    record["reference"] = {{"seconds", result.reference.seconds},
                           {"cpu_seconds", result.reference.cpu_seconds}};
  }
  const Certificate& certificate = result.certificate;
  if (certificate.angle_fit) {
    record["history"]["angles"] = NumbersJson(certificate.angle_fit->gradients);
  }
  if (certificate.radii) record["history"]["radii"] = NumbersJson(certificate.radii->gradients);
  if (certificate.equivalence) {
    record["history"]["scales"] = NumbersJson(certificate.equivalence->gradients);
  }
  if (!result.energy_gradients.empty()) {
    record["history"]["energy"] = NumbersJson(result.energy_gradients);
  }
  if (const auto limits = LimitsJson(run.limits); !limits.empty()) record["limits"] = limits;
  // As it will be read back: bytes that are no UTF-8 are replaced now, so that every output agrees.
  return Record::parse(ToLine(record));
}

std::string ToLine(const Record& record) {
  return record.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string OutcomeOf(const Record& record) { return record.value("outcome", ""); }

bool IsFinished(const Record& record, const PlannedRun& run) {
  const std::string outcome = OutcomeOf(record);
  if (outcome == kTimeLimit) return !IsRaised(record, "seconds", run.limits.seconds);
  if (outcome == kMemoryLimit) return !IsRaised(record, "memory_mib", run.limits.memory_mib);
  if (outcome == ToString(StatusCode::kOk) && run.keep_map) return record.contains("map");
  return outcome != ToString(StatusCode::kCancelled) &&
         outcome != ToString(StatusCode::kResource) && outcome != kKilled;
}

bool IsSettled(const Record& record) {
  const std::string outcome = OutcomeOf(record);
  return outcome == ToString(StatusCode::kOk) || outcome == ToString(StatusCode::kInfeasible) ||
         outcome == kUnsupported;
}

StatusOr<nlohmann::json> MethodByContent(const MethodSpec& method) {
  MethodSpec by_content = method;
  const TakeFile hash_it = [](const std::string& key, std::string* path) {
    const StatusOr<std::string> hash = HashOfFile(*path);
    if (!hash.ok()) return hash.status().In(key);
    *path = *hash;
    return Status();
  };
  // A program, and a script that it is to run, is what its file holds, wherever that lies.
  for (std::string& word : by_content.peer) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(word, error)) continue;
    if (Status s = hash_it("peer", &word); !s.ok()) return s;
  }
  const Status status = ForEachFile(hash_it, &by_content.options);
  return status.ok() ? StatusOr<nlohmann::json>(MethodJson(by_content)) : status;
}

}  // namespace cirque

#include <initializer_list>

#include <fmt/format.h>

#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/certificate_rows.h"

namespace cirque {
namespace {

using internal::CertificateRow;

template <auto Member>
std::optional<double> ReadSeconds(const Certificate& certificate) {
  return certificate.seconds.*Member;
}

constexpr CertificateRow kTimes[] = {
    {"read", "seconds", "s", "time of reading the mesh", ReadSeconds<&StageSeconds::read>},
    {"preflight", "seconds", "s", "time of checking it and making the surface",
     ReadSeconds<&StageSeconds::preflight>},
    {"subdivide", "seconds", "s", "time of subdividing it", ReadSeconds<&StageSeconds::subdivide>},
    {"decimate", "seconds", "s", "time of decimation", ReadSeconds<&StageSeconds::decimate>},
    {"pole", "seconds", "s", "time of choice of the pole", ReadSeconds<&StageSeconds::pole>},
    {"corners", "seconds", "s", "time of choice of the corners",
     ReadSeconds<&StageSeconds::corners>},
    {"cones", "seconds", "s", "time of placement of the cones", ReadSeconds<&StageSeconds::cones>},
    {"triangulation", "seconds", "s", "time of flips", ReadSeconds<&StageSeconds::triangulation>},
    {"angles", "seconds", "s", "time of angle fit", ReadSeconds<&StageSeconds::angles>},
    {"radii", "seconds", "s", "time of log radii", ReadSeconds<&StageSeconds::radii>},
    {"scales", "seconds", "s", "time of log scales", ReadSeconds<&StageSeconds::scales>},
    {"rotations", "seconds", "s", "time of rotations that were asked for",
     ReadSeconds<&StageSeconds::rotations>},
    {"injective", "seconds", "s", "time of making the image injective, solves not counted",
     ReadSeconds<&StageSeconds::injective>},
    {"refine_cones", "seconds", "s", "time of refinement of the cones",
     ReadSeconds<&StageSeconds::refine_cones>},
    {"layout", "seconds", "s", "time of cut and layout", ReadSeconds<&StageSeconds::layout>},
    {"exact", "seconds", "s", "time of the exact map", ReadSeconds<&StageSeconds::exact>},
    {"carry_back", "seconds", "s", "time of the way back to the surface, refinement included",
     ReadSeconds<&StageSeconds::carry_back>},
    {"measures", "seconds", "s", "time of measures", ReadSeconds<&StageSeconds::measures>},
    {"write", "seconds", "s", "time of writing", ReadSeconds<&StageSeconds::write>},
    {"total", "seconds", "s", "time of the map", ReadSeconds<&StageSeconds::total>},
    {"process", "seconds", "s", "time of the whole process", ReadSeconds<&StageSeconds::process>},
};

std::vector<CertificateField> FieldsOf(
    std::initializer_list<std::span<const CertificateRow>> tables) {
  std::vector<CertificateField> fields;
  for (const auto& table : tables) {
    for (const CertificateRow& row : table) {
      fields.push_back({row.name, row.summary, row.unit, row.meaning, row.value});
    }
  }
  return fields;
}

std::map<std::string, double> Read(const std::vector<CertificateField>& fields,
                                   const Certificate& certificate) {
  std::map<std::string, double> numbers;
  for (const CertificateField& field : fields) {
    if (const std::optional<double> value = field.value(certificate)) {
      numbers.emplace(field.name, *value);
    }
  }
  return numbers;
}

}  // namespace

const std::vector<CertificateField>& CertificateFields() {
  static const std::vector<CertificateField> kTable =
      FieldsOf({internal::SolveRows(), internal::MapRows()});
  return kTable;
}

const std::vector<CertificateField>& SecondsFields() {
  static const std::vector<CertificateField> kTable = FieldsOf({kTimes});
  return kTable;
}

std::map<std::string, double> NumbersOf(const Certificate& certificate) {
  std::map<std::string, double> numbers = Read(CertificateFields(), certificate);
  const auto add_family = [&](const char* name, const auto& values) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      numbers.emplace(fmt::format("{}_{}", name, k), values[k]);
    }
  };
  if (certificate.polygon) add_family("corner_vertex", certificate.polygon->corner_vertices);
  if (certificate.rotations) {
    add_family("rotation", certificate.rotations->rotations);
    add_family("boundary_turn", certificate.rotations->boundary_turns);
  }
  if (certificate.loops) {
    add_family("loop_rotation", certificate.loops->rotations);
    add_family("loop_miss", certificate.loops->misses);
  }
  return numbers;
}

std::map<std::string, double> SecondsOf(const Certificate& certificate) {
  return Read(SecondsFields(), certificate);
}

}  // namespace cirque

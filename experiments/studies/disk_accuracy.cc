// Maps to the unit disk and to rectangles, refined, against what is known of them.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "experiments/studies/accuracy_cases.h"
#include "experiments/studies/studies.h"

DEFINE_int32(levels, 4, "how often the coarsest meshes are refined, and one");

namespace cirque {
namespace {

using Level = StatusOr<AccuracyRow> (*)(int level);

struct Case {
  std::string title, value;
  Level row;
};

DiskCase Cap(int level, const std::string& refine_map) {
  return {"spherical_cap", std::tan(kPi / 6), 500 << (2 * level), -1, refine_map};
}

DiskCase Hemisphere(int level, const std::string& refine_map) {
  return {"hemisphere", 1, 500 << (2 * level), -1, refine_map};
}

const std::vector<Case>& Cases() {
  static const std::vector<Case> kTable = {
      {"Spherical cap of 60 degrees to the unit disk, the circle pattern", "rms distance",
       [](int level) { return DiskError(Cap(level, "none")); }},
      {"Spherical cap of 60 degrees to the unit disk, refined by `mips`", "rms distance",
       [](int level) { return DiskError(Cap(level, "mips")); }},
      {"Hemisphere to the unit disk, the circle pattern", "rms distance",
       [](int level) { return DiskError(Hemisphere(level, "none")); }},
      {"Hemisphere to the unit disk, refined by `mips`", "rms distance",
       [](int level) { return DiskError(Hemisphere(level, "mips")); }},
      {"Sector of an annulus, R / r = 2, 90 degrees: log(2) / (pi / 2) = 0.441271200", "modulus",
       [](int level) { return ModulusError(AnnulusSector(8 << level, 2, kPi / 2)); }},
      {"L of three squares: sqrt(3) = 1.732050808", "modulus",
       [](int level) { return ModulusError(LShape(4 << level)); }},
      {"L of three squares between its ends: 0.390850481", "modulus",
       [](int level) { return ModulusError(LShapeBetweenEnds(4 << level)); }}};
  return kTable;
}

constexpr int kPoles = 8;

/// What the vertex that is sent to infinity does to the map: a row of the table.
Status AddPoles(const std::string& name, DiskCase disk, std::string* text) {
  const StatusOr<AccuracyRow> chosen = DiskError(disk);
  if (!chosen.ok()) return chosen.status().In(name);
  std::vector<double> errors;
  for (int i = 0; i < kPoles; ++i) {
    disk.pole = static_cast<double>(i) / kPoles;
    const StatusOr<AccuracyRow> row = DiskError(disk);
    // A vertex behind a chord cannot be the pole.
    if (!row.ok() && row.status().code() == StatusCode::kInvalidInput) continue;
    if (!row.ok()) return row.status().In(name);
    errors.push_back(row->error);
  }
  if (errors.empty()) return Status::InvalidInput(name + ": no vertex can be the pole");
  std::sort(errors.begin(), errors.end());
  *text +=
      fmt::format("| {} | {} | {} | {:.3e} | {} | {:.3e} | {:.3e} |\n", name, chosen->triangles,
                  disk.refine_map, chosen->error, errors.size(), errors.front(), errors.back());
  return Status();
}

Status MakePoles(std::string* text) {
  *text += fmt::format(
      "\n### The pole\n\nThe rms distance with the pole that is chosen and with up to {} others, "
      "spread along the boundary, with the circle pattern's places as they are, refined by default "
      "and refined globally. A refined map has no pole.\n\n"
      "| surface | triangles | refined by | chosen | others | least | largest |\n"
      "|---|--:|---|--:|--:|--:|--:|\n",
      kPoles);
  for (int level = 0; level < FLAGS_levels; ++level) {
    for (const char* refine_map : {"none", "auto", "mips"}) {
      const DiskCase cap = Cap(level, refine_map), hemisphere = Hemisphere(level, refine_map);
      if (Status s = AddPoles("spherical cap", cap, text); !s.ok()) return s;
      if (Status s = AddPoles("hemisphere", hemisphere, text); !s.ok()) return s;
    }
  }
  return Status();
}

Status MakeTables(std::string* text) {
  *text =
      "# Maps to the unit disk and to rectangles against known ones\n\n"
      "Made by `studies disk_accuracy --output=results/disk_accuracy.md`. Order: of the error in "
      "the edge "
      "length.\n";
  for (const Case& which : Cases()) {
    std::vector<AccuracyRow> rows;
    for (int level = 0; level < FLAGS_levels; ++level) {
      const StatusOr<AccuracyRow> row = which.row(level);
      if (!row.ok()) return row.status().In(which.title);
      rows.push_back(*row);
    }
    *text += AccuracyTable(which.title, which.value, rows);
  }
  return MakePoles(text);
}

}  // namespace

Status RunDiskAccuracy(const StudyCall& call) {
  if (Status s = NoArguments(call); !s.ok()) return s;
  if (FLAGS_levels < 1 || FLAGS_levels > 8) {
    return Status::InvalidInput(fmt::format("--levels={}: 1 to 8 are possible", FLAGS_levels));
  }
  std::string text;
  if (Status s = MakeTables(&text); !s.ok()) return s;
  return Deliver(text);
}

}  // namespace cirque

// Maps to the unit disk and to rectangles, refined, against what is known of them.
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

const std::vector<Case>& Cases() {
  static const std::vector<Case> kTable = {
      {"Spherical cap of 60 degrees to the unit disk", "rms distance",
       [](int level) { return DiskError("spherical_cap", std::tan(kPi / 6), 500 << (2 * level)); }},
      {"Hemisphere to the unit disk", "rms distance",
       [](int level) { return DiskError("hemisphere", 1, 500 << (2 * level)); }},
      {"Sector of an annulus, R / r = 2, 90 degrees: log(2) / (pi / 2) = 0.441271200", "modulus",
       [](int level) { return ModulusError(AnnulusSector(8 << level, 2, kPi / 2)); }},
      {"L of three squares: sqrt(3) = 1.732050808", "modulus",
       [](int level) { return ModulusError(LShape(4 << level)); }},
      {"L of three squares between its ends: 0.390850481", "modulus",
       [](int level) { return ModulusError(LShapeBetweenEnds(4 << level)); }}};
  return kTable;
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
  return Status();
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

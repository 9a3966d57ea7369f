// Maps to the unit disk and to rectangles, refined, against what is known of them.
#include <cmath>
#include <iostream>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/atomic_file.h"

#include "experiments/common/blas_threads.h"
#include "experiments/common/flag_parsing.h"
#include "experiments/disk_accuracy/study.h"

DEFINE_string(output, "", "file for the tables, in Markdown; empty: standard output");
DEFINE_int32(levels, 4, "how often the coarsest meshes are refined, and one");
DECLARE_bool(help);

namespace cirque {
namespace {

constexpr char kSource[] = "experiments/disk_accuracy/";

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

int Conclude(const Status& status) {
  if (!status.ok()) std::cerr << "disk_accuracy: " << status.message() << "\n";
  return ExitStatus(status.code());
}

Status Run(std::string* text) {
  *text =
      "# Maps to the unit disk and to rectangles against known ones\n\n"
      "Made by `disk_accuracy --output=results/disk_accuracy.md`. Order: of the error in the edge "
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

int Main(int argc, char** argv) {
  UseOneBlasThread();
  const auto others = ParseFlags(argc, argv, kSource);
  if (!others.ok()) return Conclude(others.status());
  if (FLAGS_help) {
    std::cout << FlagHelp(kSource);
    return 0;
  }
  if (!others->empty() || FLAGS_levels < 1 || FLAGS_levels > 8) {
    return Conclude(Status::InvalidInput("no arguments, and --levels from 1 to 8; see --help"));
  }
  std::string text;
  if (Status s = Run(&text); !s.ok()) return Conclude(s);
  if (!FLAGS_output.empty()) return Conclude(WriteFileAtomically(FLAGS_output, text));
  std::cout << text;
  return 0;
}

}  // namespace
}  // namespace cirque

int main(int argc, char** argv) { return cirque::Main(argc, argv); }

#include "experiments/audit_energies/report.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/audit_energies/checks.h"

namespace cirque::audit_energies {
namespace {

constexpr int kColumn = 11;

std::string Entry(const Finding& finding) {
  if (!finding.applies) return "-";
  return finding.ok() ? "ok" : fmt::format("{:.2g}", finding.figure);
}

std::string Failures(const AuditRow& row) {
  if (!row.status.ok()) return fmt::format("{}: {}\n", row.energy, row.status.message());
  std::string text;
  for (const Finding& f : row.findings) {
    if (f.ok()) continue;
    text += fmt::format("{}: {} failed: {:.3g} > {:g} at {}\n", row.energy, f.check, f.figure,
                        f.bound, f.where);
  }
  return text;
}

}  // namespace

bool AllOk(const std::vector<AuditRow>& rows) {
  return !rows.empty() &&
         std::all_of(rows.begin(), rows.end(), [](const AuditRow& row) { return row.ok(); });
}

std::string ToText(const std::vector<AuditRow>& rows) {
  std::size_t width = 6;
  for (const AuditRow& row : rows) width = std::max(width, row.energy.size());
  std::string text = fmt::format("{:<{}}", "energy", width);
  for (const Check& check : Checks()) text += fmt::format("{:>{}}", check.name, kColumn);
  text += "\n";
  for (const AuditRow& row : rows) {
    text += fmt::format("{:<{}}", row.energy, width);
    for (const Finding& f : row.findings) text += fmt::format("{:>{}}", Entry(f), kColumn);
    text += row.status.ok() ? "\n" : "  not audited\n";
  }
  for (const AuditRow& row : rows) text += Failures(row);
  return text;
}

std::string ToJson(const std::vector<AuditRow>& rows) {
  nlohmann::ordered_json json;
  json["ok"] = AllOk(rows);
  json["energies"] = nlohmann::ordered_json::array();
  for (const AuditRow& row : rows) {
    nlohmann::ordered_json energy = {{"energy", row.energy}, {"ok", row.ok()}};
    if (!row.status.ok()) energy["error"] = row.status.message();
    energy["checks"] = nlohmann::ordered_json::array();
    for (const Finding& f : row.findings) {
      energy["checks"].push_back({{"check", f.check},
                                  {"applies", f.applies},
                                  {"ok", f.ok()},
                                  {"figure", f.figure},
                                  {"bound", f.bound},
                                  {"where", f.where}});
    }
    json["energies"].push_back(energy);
  }
  return json.dump(2) + "\n";
}

}  // namespace cirque::audit_energies

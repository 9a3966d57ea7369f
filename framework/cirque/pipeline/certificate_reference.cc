#include <fmt/format.h>

#include "cirque/pipeline/certificate.h"

namespace cirque {
namespace {

std::string Section(const std::vector<CertificateField>& fields) {
  std::string text = "| name | unit | meaning |\n|---|---|---|\n";
  for (const CertificateField& field : fields) {
    text += fmt::format("| `{}` | {} | {} |\n", field.name, field.unit, field.meaning);
  }
  return text;
}

}  // namespace

std::string CertificateReference() {
  std::string text = fmt::format(
      "# Certificates\n\n"
      "Every run leaves a certificate, a JSON object; this page is written from the table of its\n"
      "numbers (`circle_patterns --certificate_help`). Angles are in radians, lengths relative,\n"
      "vertices and faces numbered as in the input file, from 0. What a run did not come to is\n"
      "absent; NaN and infinity are null. Nothing in a certificate steers the program.\n\n"
      "| key | content |\n|---|---|\n"
      "| `schema`, `version` | \"{}\", {} |\n"
      "| `outcome` | ok, inaccurate, invalid_input, infeasible, unrepresentable, not_converged, "
      "cancelled |\n"
      "| `message` | why, when the outcome is not ok |\n"
      "| `overlap` | injective; boundary_touches (no two boundary edges cross, but some touch);"
      " boundary_overlaps; unknown |\n"
      "| `values` | the numbers below, and `corner_vertex_0`, `corner_vertex_1`, ... of a polygon "
      "|\n"
      "| `seconds` | wall time by stage |\n"
      "| `solvers` | of `angles` and `radii`, with the reason where one was chosen automatically "
      "|\n"
      "| `history` | of `angles` and `radii`: max \\|gradient\\| at the start of the last solve and"
      " after every iteration |\n"
      "| `ladder` | where the road that was asked for led to no map: `tried`, the roads in order "
      "with `rung` (the first is \"as_asked\"), `outcome` and `message`, `made_with`, what the map "
      "that came out was made with, and `since`, why |\n"
      "| `infeasibility` | with outcome infeasible: the proof, which verify_map checks |\n",
      kCertificateSchema, kCertificateVersion);
  std::vector<CertificateField> group;
  const auto flush = [&] {
    if (!group.empty()) text += "\n## " + group[0].summary + "\n\n" + Section(group);
    group.clear();
  };
  for (const CertificateField& field : CertificateFields()) {
    if (!group.empty() && group[0].summary != field.summary) flush();
    group.push_back(field);
  }
  flush();
  return text + "\n## seconds\n\n" + Section(SecondsFields());
}

}  // namespace cirque

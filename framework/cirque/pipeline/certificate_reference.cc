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
      "| `overlap` | injective (no point is covered twice) or boundary_overlaps, exactly; unknown "
      "where triangles are flipped |\n"
      "| `values` | the numbers below, and `corner_vertex_0`, `corner_vertex_1`, ... of a polygon, "
      "`rotation_0`, ... along loops and `boundary_turn_0`, ... between boundary loops [rad]; "
      "`loop_rotation_0`, ... along loops of a file and `loop_miss_0`, ... what is missing to what "
      "it "
      "asks for |\n"
      "| `seconds` | wall time by stage |\n"
      "| `solvers` | of `angles` and `radii`, with the reason where one was chosen automatically "
      "|\n"
      "| `history` | of `angles` and `radii`: max \\|gradient\\| at the start of the last solve and"
      " after every iteration |\n"
      "| `ladder` | where the road that was asked for led to no map: `tried`, the roads in order "
      "with `rung` (the first is \"as_asked\"), `outcome`, `message` and wall `seconds`, "
      "`made_with`, what the map that came out was made with, and `since`, why |\n"
      "| `injectivity` | where an injective image was asked for and it overlapped itself: `tried`, "
      "the stages in order with `stage`, `outcome` (injective, or why not) and wall `seconds`, and "
      "`made_by` |\n"
      "| `repair` | where the mesh was repaired: the faces set aside by reason, the vertices "
      "welded and split, the edges of more than two faces opened (pairs of vertices), and what was "
      "seen "
      "and left: `t_junctions` and the number of `coincident_edges` |\n"
      "| `components` | of a mesh of several components: a certificate of each with `first_face`, "
      "`faces` and `vertices`, in the order of their first faces. What stands beside it is about "
      "all of them: the worst outcome with the message of the largest component that has it, sums "
      "of counts and times, figures of the whole atlas |\n"
      "| `infeasibility` | with outcome infeasible: the proof, which verify_map checks; its "
      "`triangle_face` and `triangle_corner` (three corners of that face) say which triangle each "
      "of `face_multiplier` belongs to |\n",
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

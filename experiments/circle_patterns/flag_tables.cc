#include "experiments/circle_patterns/flag_tables.h"

#include <string>
#include <utility>
#include <vector>

#include "cirque/domains/domain.h"

#include "experiments/common/flag_parsing.h"

namespace cirque {
namespace {

constexpr char kProgram[] = "circle_patterns";

/// A table whose rows are about these, group by group.
template <class T>
OptionTable<T> Grouped(std::vector<std::pair<std::string, std::vector<Option<T>>>> groups) {
  std::vector<Option<T>> rows;
  for (auto& [group, own] : groups) {
    for (Option<T>& row : own) rows.push_back(std::move(row).About(group));
  }
  return OptionTable<T>(kProgram, std::move(rows));
}

/// A flag that names a file.
Option<CirclePatternsJob> FileFlag(const std::string& name, std::string CirclePatternsJob::*member,
                                   const std::string& help) {
  return Option<CirclePatternsJob>(name, member, help).Unit(kFileUnit);
}

}  // namespace

const OptionTable<ProgramSettings>& SettingsTable() {
  using S = ProgramSettings;
  static const OptionTable<S> kTable = Grouped<S>(
      {{"Output",
        {{"measures", &S::measures,
          "files of distortion measures, a comma between: .csv (per face), .json (per map), .ply "
          "or "
          ".ply:MEASURE (colours)"}}},
       {"Program",
        {Option<S>(
             "threads", &S::threads,
             "most threads of loops over faces and edges; 0: as CIRQUE_NUM_THREADS says, else "
             "all cores")
             .Between(0, 1e6),
         {"quiet", &S::quiet, "say nothing but what went wrong"},
         {"certificate_help", &S::certificate_help,
          "writes the reference of certificates, in Markdown"}}}});
  return kTable;
}

const OptionTable<CirclePatternsJob>& JobTable() {
  using J = CirclePatternsJob;
  static const OptionTable<J> kTable = Grouped<J>(
      {{"Files",
        {FileFlag(
             "io", &J::input,
             "the mesh: .obj, .off, .ply, .stl or .om, may be packed (.gz); -: standard input; the "
             "same as IN"),
         FileFlag(
             "oo", &J::output,
             "the map as texture coordinates: .obj (the input's text where that is one), .ply, "
             ".off or .glb; the same as OUT"),
         FileFlag("ic", &J::input_con, ".con: an intrinsic metric, instead of -io"),
         FileFlag("oc", &J::con, ".con: the flat metric on the triangulation where it was solved"),
         {"con", &J::con_form,
          "form of -oc; the thesis's has vertices and lengths on lines of their own, no "
          "neighbours"},
         {"overwrite", &J::overwrite, "outputs may be inputs"}}},
       {"Cones",
        {FileFlag("iv", &J::cones,
                  "cone file: 'vertex min max' a line, angle sums in multiples of pi"),
         FileFlag("angle_sums", &J::angle_sums,
                  "file of one target angle sum in radians per vertex, instead of -iv"),
         FileFlag(
             "rotations", &J::rotations,
             "file of what directions turn by along loops: 'rotation face face ...' a line, in "
             "radians; what the cones make of them is measured and said"),
         {"meet_rotations", &J::meet_rotations,
          "those of -rotations are met, at the price of conformality"}}},
       {"Cuts",
        {FileFlag("ie", &J::cut,
                  "edge-cut file: 'from to face' a line; without it a short cut is found"),
         {"cut_paths", &J::cut_paths,
          "'a-b,c-d': open shortest paths between these vertices, counted from 1, instead of "
          "-ie"}}},
       {"Solver",
        {{"no", &J::layout_only,
          "no optimisation: cut and lay out the metric of -ic, which is flat already"}}},
       {"Sphere",
        {FileFlag("latlong", &J::latlong, ".obj to write with latitude and longitude as texture")}},
       {"Output",
        {FileFlag(
             "exact", &J::exact,
             ".obj, .ply, .off or .glb to write: the mesh refined so that the map has no error "
             "but rounding: linear on the triangles it was solved on, none flipped, no vertex "
             "moved; in an .obj, faces of the input are groups"),
         FileFlag("projective", &J::projective,
                  ".obj to write, of conformal equivalence (--pattern=equivalence): the same with "
                  "homogeneous texture coordinates, vt wu wv w, whose quotients u, v at each pixel "
                  "are its own projective interpolation"),
         FileFlag("view", &J::view, ".html to write: the surface and its map, to turn and zoom"),
         FileFlag("picture", &J::picture,
                  ".svg or .png to write: surface, layout, seams, cones and distortion; "
                  "FILE:MEASURE: in the colours of that measure"),
         FileFlag("certificate", &J::certificate,
                  ".json for the evidence: residuals, flips, overlap, what was tried. Without this "
                  "flag it is written only where the outcome is not ok, as OUT.certificate.json, "
                  "beside it the faces that carry a proof that there is no map"),
         {"flip_back", &J::flip_back,
          "-oc after undoing every flip that the flat metric allows"}}}});
  return kTable;
}

const OptionTable<DomainRequest>& DomainTable() {
  static const OptionTable<DomainRequest> kTable(
      kProgram, {Option<DomainRequest>("domain", &DomainRequest::name,
                                       "shape to map onto; its vertices are counted from 1")
                     .Checked([](const std::string& name) { return Domains().Find(name).status(); })
                     .OneOf(Domains().Names())
                     .About("Shape")});
  return kTable;
}

}  // namespace cirque

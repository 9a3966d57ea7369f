// What --help and the manual page say beside the flags.
#include "experiments/circle_patterns/flags.h"

namespace cirque {

Manual ProgramManual() {
  Manual manual;
  manual.program = "circle_patterns";
  manual.purpose = "maps a triangle mesh conformally, by a circle pattern";
  manual.usage = {{"IN OUT.obj", "IN flattened: the mesh as it is, with texture coordinates"},
                  {"IN", "the same into a file beside it: mesh.ply into mesh_uv.obj"},
                  {"--domain=disk IN OUT.obj", "onto a shape"},
                  {"--domain=sphere IN OUT.obj", "a closed surface onto the sphere, or OUT.ply"},
                  {"IN.con OUT.obj", "the same from an intrinsic metric"},
                  {"OPTIONS.txt", "all options in one text file, which begins with a flag"},
                  {"- -", "standard input and output, as OBJ"},
                  {"IN --view=A.html --picture=B.svg", "and shown"}};
  manual.rules = {
      "Flags are written with one dash or two, their values behind '=' or a blank. Vertices and "
      "faces "
      "are named by their numbers in the file, from 1.",
      "What is written: OUT, and what flags ask for. Where the outcome is not ok also the "
      "certificate "
      "that says why, OUT.certificate.json, and where there is a proof that no map exists the "
      "faces "
      "and vertices that carry it, OUT.infeasible.csv and OUT.infeasible.ply. Nothing is half "
      "written.",
      "A terminal is told the stage and how long it has taken; a pipe is not, nor is anybody with "
      "--quiet.",
      "`mpirun -n 4 circle_patterns --radii_solver=newton_amg ...` distributes the work on huge "
      "meshes over processes, where PETSc was built in."};
  manual.statuses = {{"0", "done"},
                     {"1", "not converged, inaccurate or interrupted"},
                     {"2", "bad input, or the machine failed"},
                     {"3", "infeasible, with a proof"},
                     {"4", "a map exists that doubles do not hold in one chart"}};
  manual.first = {"domain",  "fill_holes", "cones",  "cone_budget", "iv",
                  "seams",   "cut_paths",  "ie",     "refine_map",  "view",
                  "picture", "measures",   "repair", "uv",          "certificate",
                  "quiet",   "threads",    "help",   "version"};
  manual.groups = {"Files", "Shape", "Cones", "Cuts", "Solver", "Sphere", "Output", "Program"};
  return manual;
}

}  // namespace cirque

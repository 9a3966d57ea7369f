#include <algorithm>

#include <fmt/format.h>

#include "cirque/core/text.h"

#include "experiments/run_experiment/schema.h"

namespace cirque {
namespace {

constexpr char kIntroduction[] =
    "A config is a YAML file. Every mesh meets every method; a key marked * may hold a list, and\n"
    "then every value of it makes a run of its own. Relative paths start at the folder that holds\n"
    "configs/, or, for a config elsewhere, at the config's own folder.\n";

constexpr char kExample[] =
    "\nExample:\n"
    "  question: Does a larger margin cost conformality?\n"
    "  meshes:\n"
    "    - file: ../shared/meshes/bff-*.obj\n"
    "      optional: true\n"
    "    - generator: bumpy_terrain\n"
    "      triangles: [1000, 4000]\n"
    "  methods:\n"
    "    - name: quadratic\n"
    "      epsilon: [1e-3, 1e-2]\n";

std::string Notes(const SchemaField& field) {
  std::vector<std::string> notes;
  if (field.required) notes.push_back("required");
  if (!field.one_of.empty()) notes.push_back("one such key in each entry");
  if (!field.beside.empty()) notes.push_back("beside " + Join(field.beside, " or "));
  if (!field.default_text.empty()) notes.push_back("default " + field.default_text);
  return notes.empty() ? "" : " (" + Join(notes, "; ") + ")";
}

std::string Entry(const SchemaField& field) {
  const int depth = static_cast<int>(std::count(field.path.begin(), field.path.end(), '.'));
  const std::string key =
      std::string(2 * (depth + 1), ' ') + field.Key() + (field.matrix ? "*" : "") + ":";
  return fmt::format("{:<22}{}{}\n{:22}{}\n", key, field.help, Notes(field), "",
                     Expectation(field));
}

}  // namespace

std::string ConfigHelp(const Schema& schema) {
  std::string text = std::string(kIntroduction) + "\n";
  for (const SchemaField& field : schema) text += Entry(field);
  return text + kExample;
}

}  // namespace cirque

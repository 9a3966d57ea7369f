#include <algorithm>

#include <fmt/format.h>

#include "cirque/core/text.h"

#include "experiments/run_experiment/config/schema.h"

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
    "    - file: $MESHES/bff-*.obj\n"
    "      optional: true\n"
    "    - generator: bumpy_terrain\n"
    "      triangles: [1000, 4000]\n"
    "  methods:\n"
    "    - name: quadratic\n"
    "      epsilon: [1e-3, 1e-2]\n";

constexpr std::size_t kIndent = 22;

std::string Notes(const SchemaField& field) {
  std::vector<std::string> notes;
  if (field.required) notes.push_back("required");
  if (field.list) notes.push_back("one or a list");
  if (!field.one_of.empty()) notes.push_back("one such key in each entry");
  if (!field.beside.empty()) notes.push_back("beside " + Join(field.beside, " or "));
  if (!field.default_text.empty()) notes.push_back("default " + field.default_text);
  return notes.empty() ? "" : " (" + Join(notes, "; ") + ")";
}

std::string Entry(const SchemaField& field) {
  const int depth = static_cast<int>(std::count(field.path.begin(), field.path.end(), '.'));
  const std::string key =
      std::string(2 * (depth + 1), ' ') + field.Key() + (field.matrix ? "*" : "") + ":";
  return Wrapped(key + " ", field.help + Notes(field), kIndent) +
         Wrapped("", Expectation(field), kIndent);
}

constexpr char kPageHead[] =
    "# Config files of run_experiment\n\n"
    "<!-- Written by `run_experiment --help_config --markdown`; a test keeps it up to date. -->\n\n"
    "A config is a YAML file. Every mesh meets every method; a key marked * may hold a list, and "
    "then\n"
    "every value of it makes a run of its own. Relative paths start at the folder that holds\n"
    "`configs/`, or, for a config elsewhere, at the config's own folder. `meshes.file` is the key\n"
    "`file` of an entry of the list `meshes`. Mistakes are refused all at once, with file, line "
    "and\n"
    "column, before anything is run.\n\n"
    "| key | meaning | value |\n|---|---|---|\n";

std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text)
    escaped += c == '|' || c == '*' ? std::string("\\") + c : std::string(1, c);
  return escaped;
}

constexpr char kPageEnd[] = R"(
## Results

The folder `output` holds

- `results.jsonl`: one JSON object a run, appended when it ends: `key` (a hash of mesh content, method
  and code; finished keys are not run again), `mesh`, `method`, `repeat`, `outcome`, `message`,
  `overlap`, `values`, `seconds`, `history` (max |gradient| by iteration of the solves `angles`,
  `radii`, `scales` and `energy`), `peak_memory_mib`, `limits`, `map`, `provenance` (commit, config and its hash, libraries,
  CPU, threads, start).
- `results.csv`: the same as a table.
- `certificates/KEY.json`: the infeasibility certificate of a run; `maps/KEY.obj`, `maps/KEY.certificate.json`:
  a map that was kept.
- `results.shard-I-of-N.jsonl`: the records of a shard, until `--merge` takes them into `results.jsonl`.

Outcomes: `ok`; `infeasible` (with a certificate); `not_converged`; `unrepresentable`; `invalid_input`; `cancelled`
(made again); `exception` (the run threw); `crash` (its process ended without a record); `time_limit`
and `memory_limit` (made again when the limit is raised). Each but `ok` has a `message`.
)";

}  // namespace

std::string ConfigHelp(const Schema& schema) {
  std::string text = std::string(kIntroduction) + "\n";
  for (const SchemaField& field : schema) text += Entry(field);
  return text + kExample;
}

std::string ConfigMarkdown(const Schema& schema) {
  std::string text = kPageHead;
  for (const SchemaField& field : schema) {
    text += fmt::format("| `{}`{} | {}{} | {} |\n", field.path, field.matrix ? " *" : "",
                        Escaped(field.help), Escaped(Notes(field)), Escaped(Expectation(field)));
  }
  return text + kPageEnd;
}

}  // namespace cirque

"""Records of run_experiment as scripts read them, and their tables; needs Python alone."""
import json
import math
import pathlib
import statistics

# What methods' keys were called in records of earlier releases.
FORMER_KEYS = {"angle_fit": "angle_objective", "angle_strategy": "angle_solver", "strategy": "radii_solver"}


class BadRecords(Exception):
    """The records are missing or are not those of the study."""


class Run:
    """One record, with the parts that studies ask for by name."""

    def __init__(self, record):
        self.record = record
        self.mesh = record["mesh"]["name"]
        self.family = record["mesh"].get("family") or self.mesh
        self.triangles = record["mesh"]["triangles"]
        self.method = {FORMER_KEYS.get(key, key): value for key, value in record["method"].items()}
        self.group = record["method"]["name"].split(",")[0]
        self.outcome = record["outcome"]
        self.ok = self.outcome == "ok"

    def value(self, name):
        """A measured value; None where the run has none."""
        return self.record.get("values", {}).get(name)

    def seconds(self, stage):
        return self.record.get("seconds", {}).get(stage)

    @property
    def cpu(self):
        return self.record.get("cpu_seconds")

    @property
    def map_cpu(self):
        return self.record.get("map_cpu_seconds")

    @property
    def memory(self):
        return self.record.get("peak_memory_mib")

    @property
    def reference(self):
        return self.record.get("reference", {}).get("cpu_seconds")


def read(folder):
    """The runs of FOLDER/results.jsonl, of every run its last record, a torn line left out."""
    path = pathlib.Path(folder) / "results.jsonl"
    if not path.exists():
        raise BadRecords(f"{path}: does not exist; run the study's config first")
    runs = {}
    for line in path.read_text().splitlines():
        try:
            record = json.loads(line)
            runs[record["mesh"]["name"], record["method"]["name"], record["repeat"]] = Run(record)
        except (ValueError, KeyError, TypeError):
            continue
    if not runs:
        raise BadRecords(f"{path}: holds no record of run_experiment")
    return list(runs.values())


def in_order(items):
    """Each of them once, in the order of their first appearance."""
    return list(dict.fromkeys(items))


def by_size(runs):
    """The meshes' names, the smallest first."""
    size = {}
    for run in runs:
        size[run.mesh] = max(size.get(run.mesh, 0), run.triangles)
    return sorted(size, key=lambda mesh: (size[mesh], mesh))


def number(value, text="{:.3g}"):
    return "-" if value is None else text.format(value)


def shown(run, value, text="{:.3g}"):
    """A cell of a table: the value, or why there is none."""
    if run is None:
        return ""
    return number(value, text) if run.ok else run.outcome


def table(head, rows, texts=1):
    """Markdown; the first `texts` columns are texts, the others numbers."""
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * texts + "--:|" * (len(head) - texts)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def by_choice(runs, choice):
    """{mesh: {choice(run): run}}, smallest mesh first."""
    return {mesh: {choice(run): run for run in runs if run.mesh == mesh} for mesh in by_size(runs)}


def value_table(of_mesh, names, value, text):
    """A value of every choice on every mesh (by_choice)."""
    rows = [[mesh, next(iter(of.values())).triangles]
            + [shown(of.get(name), of[name].value(value) if name in of else None, text) for name in names]
            for mesh, of in of_mesh.items()]
    return table(["mesh", "triangles"] + [f"`{name}`" for name in names], rows)


def quantiles(values):
    """"median (least to greatest)"."""
    if not values:
        return "-"
    return f"{statistics.median(values):.3g} ({min(values):.3g} to {max(values):.3g})"


def median_interval(values):
    """Order statistics between which the median lies at least 19 times in 20, whatever the distribution."""
    values = sorted(values)
    n = len(values)
    if n > 1000:  # where the binomial distribution is the normal one, and powers of 1/2 vanish
        below = math.floor(n / 2 - 0.98 * math.sqrt(n))
        return values[below - 1], values[n - below]
    below, probability = 0, 0.5 ** n
    cumulated = probability
    while cumulated <= 0.025 and below < n // 2:
        below += 1
        probability *= (n - below + 1) / below
        cumulated += probability
    if below == 0:
        return -math.inf, math.inf
    return values[below - 1], values[n - below]

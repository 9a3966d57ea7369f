"""Boundaries by name beside cones: what lowers area distortion, and at what price."""
import statistics

from tables import records
from tables.records import by_choice, number, plt, quantiles, shown, table, value_table

OUTPUT = "boundaries"
REFERENCE = "isometric"


def lever(run):
    """What the run changed: the boundary's name, or how many cones."""
    cones = run.method.get("cone_budget", -1)
    return f"{cones} cones" if run.group == "cones" else run.method.get("boundary", "free")


def ratios(of_mesh, name, value):
    """value(name) over value(REFERENCE) on the meshes that have both."""
    both = [(levers[name], levers[REFERENCE]) for levers in of_mesh.values() if name in levers and REFERENCE in levers]
    return [a.value(value) / b.value(value) for a, b in both if a.ok and b.ok and b.value(value)]


def summary(of_mesh, names):
    rows = []
    for name in names:
        found = [levers[name] for levers in of_mesh.values() if name in levers]
        mapped = [run for run in found if run.ok]
        overlapping = sum(1 for run in mapped if run.record.get("overlap") == "boundary_overlaps")
        rows.append([f"`{name}`", f"{len(mapped)} of {len(found)}"]
                    + [quantiles(ratios(of_mesh, name, value)) for value in
                       ("log_scale_l2", "log_scale_max", "symmetric_dirichlet")]
                    + [number(statistics.median(run.value("quasi_conformal_mean") for run in mapped) if mapped else None,
                              "{:.4f}"), overlapping])
    head = ["lever", "maps", "log scale L2", "log scale max", "symmetric Dirichlet", "median qc mean", "overlaps"]
    return table(head, rows, texts=2)


def tables(runs):
    of_mesh = by_choice(runs, lever)
    names = records.in_order(lever(run) for run in runs)
    worst = [[mesh] + [shown(levers.get(name), levers[name].value("log_scale_max") if name in levers else None, "{:.2f}")
                       for name in names] for mesh, levers in of_mesh.items()]
    return "\n\n".join(["# Boundaries by name",
                        f"Over `{REFERENCE}` on the same mesh: median (least to greatest).", summary(of_mesh, names),
                        "## L2 of the log scale about its mean, by area",
                        value_table(of_mesh, names, "log_scale_l2", "{:.4f}"),
                        "## Its maximum", table(["mesh"] + [f"`{name}`" for name in names], worst)])


def draw(runs, path):
    of_mesh = by_choice(runs, lever)
    names = [name for name in records.in_order(lever(run) for run in runs) if name != REFERENCE]
    figure, axis = plt.subplots(figsize=(6, 3))
    for place, name in enumerate(names):
        axis.plot([place] * len(ratios(of_mesh, name, "log_scale_l2")), ratios(of_mesh, name, "log_scale_l2"), "_",
                  markersize=12, color=records.COLOURS[place % len(records.COLOURS)])
    axis.axhline(1, color="0.4", linewidth=0.8)
    axis.set_xticks(range(len(names)), names, rotation=30, ha="right")
    axis.set(ylabel=f"L2 of the log scale over that of {REFERENCE}", yscale="log")
    records.save(figure, path)

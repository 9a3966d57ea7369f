"""Boundaries, cones and maps that are not conformal: what each takes off area distortion, and at what price."""
import statistics

from tables import records
from tables.records import by_choice, number, plt, quantiles, table, value_table

OUTPUT = "levers"
REFERENCE = "isometric"
FIGURES = [("log_scale_l2", "L2 of the log scale about its mean, by area", "{:.4f}"),
           ("log_scale_max", "Its maximum", "{:.2f}"),
           ("symmetric_dirichlet", "Symmetric Dirichlet energy (2: an isometry)", "{:.3f}"),
           ("quasi_conformal_mean", "Mean quasi-conformal distortion (1: conformal)", "{:.4f}")]


def lever(run):
    """What the run changed: the boundary's name, how many cones, or the energy."""
    if run.group == "cones":
        return f"{run.method['cone_budget']} cones"
    return run.method.get("refine_map" if run.group == "beyond" else "boundary", "free")


def ratios(of_mesh, name, value):
    """value(name) over value(REFERENCE) on the meshes that have both, but for those that are flat as they are."""
    both = [(levers[name], levers[REFERENCE]) for levers in of_mesh.values() if name in levers and REFERENCE in levers]
    return [a.value(value) / b.value(value) for a, b in both if a.ok and b.ok and b.value("log_scale_l2") > 1e-6]


def summary(of_mesh, names):
    rows = []
    for name in names:
        found = [levers[name] for levers in of_mesh.values() if name in levers]
        mapped = [run for run in found if run.ok]
        overlapping = sum(1 for run in mapped if run.record.get("overlap") == "boundary_overlaps")
        median = {value: statistics.median(run.value(value) for run in mapped) if mapped else None
                  for value in ("quasi_conformal_mean", "quasi_conformal_p99")}
        times = [run.cpu / levers[REFERENCE].cpu for levers in of_mesh.values() for at, run in levers.items()
                 if at == name and run.ok and levers.get(REFERENCE) and levers[REFERENCE].cpu]
        rows.append([f"`{name}`", f"{len(mapped)} of {len(found)}"]
                    + [quantiles(ratios(of_mesh, name, value)) for value, _, _ in FIGURES[:3]]
                    + [number(median[value], "{:.3f}") for value in median] + [overlapping, quantiles(times)])
    head = ["lever", "maps", "log scale L2", "log scale max", "symmetric Dirichlet", "median qc mean", "median qc p99",
            "overlaps", "time"]
    return table(head, rows, texts=2)


def tables(runs):
    of_mesh = by_choice(runs, lever)
    names = records.in_order(lever(run) for run in runs)
    parts = ["# Which lever to pull against area distortion",
             f"Over `{REFERENCE}` on the same mesh: median (least to greatest). What to take when: "
             "[levers](../framework/docs/levers.md).", summary(of_mesh, names)]
    for value, title, form in FIGURES:
        parts += [f"## {title}", value_table(of_mesh, names, value, form)]
    return "\n\n".join(parts)


def draw(runs, path):
    of_mesh = by_choice(runs, lever)
    names = [name for name in records.in_order(lever(run) for run in runs) if name != REFERENCE]
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.4))
    for axis, (value, title) in zip(axes, [("log_scale_l2", "L2 of the log scale"), ("quasi_conformal_mean", "mean qc")]):
        for place, name in enumerate(names):
            found = ratios(of_mesh, name, value)
            axis.plot([place] * len(found), found, "_", markersize=12, color=records.COLOURS[place % len(records.COLOURS)])
        axis.axhline(1, color="0.4", linewidth=0.8)
        axis.set_xticks(range(len(names)), names, rotation=35, ha="right")
        axis.set(ylabel=f"{title} over that of {REFERENCE}", yscale="log")
    records.save(figure, path)

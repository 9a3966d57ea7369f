"""Circle patterns beside conformally equivalent metrics on the same meshes, with the same cones."""
from tables import records
from tables.records import number, plt, quantiles, shown, table

OUTPUT = "circle_or_equivalence"
PATTERNS = ["circle", "equivalence"]
GROUPS = {"plain": "as the flat metric gives it, at the mesh's vertices",
          "exact": "as the flat metric gives it, exact: on the triangles that it was solved on",
          "refined": "refined, as by default"}


def figure(run, name):
    """Of the map that the group is about."""
    return run.value(f"exact_{name}" if run.group == "exact" else name)


def pair(runs, mesh, group):
    """The runs of both patterns, None where there is none."""
    own = {run.method["pattern"]: run for run in runs if run.mesh == mesh and run.group == group}
    return [own.get(pattern) for pattern in PATTERNS]


def both(runs, group):
    """(circle, equivalence) of the meshes that both map."""
    pairs = [pair(runs, mesh, group) for mesh in records.by_size(runs)]
    return [(a, b) for a, b in pairs if a and b and a.ok and b.ok]


def ratios(pairs, value):
    """Equivalence over circle."""
    values = [(value(a), value(b)) for a, b in pairs]
    return [b / a for a, b in values if a and b is not None]


def outcomes(runs, group, pattern):
    found = [run.outcome for run in runs if run.group == group and run.method["pattern"] == pattern]
    return ", ".join(f"{found.count(outcome)} {outcome}" for outcome in sorted(set(found), key=found.count, reverse=True))


def summary(runs, group):
    pairs = both(runs, group)
    rows = [["outcomes", outcomes(runs, group, "circle"), outcomes(runs, group, "equivalence")],
            ["qc mean - 1", "1", quantiles(ratios(pairs, lambda run: figure(run, "quasi_conformal_mean") - 1))],
            ["qc max", "1", quantiles(ratios(pairs, lambda run: figure(run, "quasi_conformal_max")))],
            ["log area ratio", "1", quantiles(ratios(pairs, lambda run: figure(run, "log_area_ratio_l2")))],
            ["CPU time of the map", "1", quantiles(ratios(pairs, lambda run: run.map_cpu or run.cpu))]]
    return "\n\n".join([f"## The map {GROUPS[group]}", f"Figures of {len(pairs)} meshes that both map, as multiples of the circle "
                        "pattern's: median (least to greatest).", table(["", *PATTERNS], rows, texts=3)])


def meshes(runs, group):
    rows = []
    for mesh in records.by_size(runs):
        circle, other = pair(runs, mesh, group)
        if not any(run and run.outcome not in ("invalid_input", "failed") for run in (circle, other)):
            continue
        triangles = (circle or other).triangles
        rows.append([mesh, triangles, *(shown(run, run and figure(run, "quasi_conformal_mean"), "{:.4f}") for run in (circle, other)),
                     *(shown(run, run and figure(run, "log_area_ratio_l2"), "{:.3f}") for run in (circle, other)),
                     *(number(run and run.cpu, "{:.2f}") for run in (circle, other)),
                     number(other and other.value("scales_iterations"), "{:.0f}"),
                     number(other and other.value("ptolemy_flips"), "{:.0f}"),
                     number(other and other.value("flipped_in_chart"), "{:.0f}")])
    head = ["mesh", "triangles", "qc mean, circle", "equivalence", "area, circle", "equivalence", "CPU s, circle", "equivalence",
            "steps", "Ptolemy flips", "flipped on the input"]
    return "\n\n".join([f"### {GROUPS[group][0].upper()}{GROUPS[group][1:]}, mesh by mesh", table(head, rows)])


def tables(runs):
    groups = [group for group in GROUPS if any(run.group == group for run in runs)]
    return "\n\n".join(["# Circle pattern or conformal equivalence", *(summary(runs, group) for group in groups),
                        *(meshes(runs, group) for group in groups)])


def draw(runs, path):
    drawing, axis = plt.subplots(figsize=(5, 4))
    pairs = both(runs, "plain")
    axis.plot([a.value("quasi_conformal_mean") - 1 for a, _ in pairs], [b.value("quasi_conformal_mean") - 1 for _, b in pairs],
              "o", markersize=3, color=records.COLOURS[0])
    axis.set(xlabel="quasi_conformal_mean - 1, circle pattern", ylabel="conformal equivalence", xscale="log", yscale="log")
    records.save(drawing, path)

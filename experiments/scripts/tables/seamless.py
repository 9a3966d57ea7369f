"""Rotations along handles that are multiples, beside free ones: what is met, and what it costs."""
from tables import records
from tables.records import number, plt, quantiles, table

OUTPUT = "seamless"
NAMES = ["free", "halves", "thirds"]
ACCURACY = 1e-10  # rad


def by_group(runs):
    """{mesh: {method: run}}, smallest mesh first."""
    return {mesh: {run.group: run for run in runs if run.mesh == mesh} for mesh in records.by_size(runs)}


def is_met(run):
    miss = run.value("holonomy_miss")
    return run.ok and miss is not None and miss <= ACCURACY and run.value("rotation_order") in (4, 6)


def over_free(of_mesh, group, value):
    """value of the group over that of free rotations, on the meshes that have both."""
    pairs = [(of[group], of["free"]) for of in of_mesh.values() if group in of and "free" in of]
    return [a.value(value) / b.value(value) for a, b in pairs if a.ok and b.ok and b.value(value)]


def seconds_over_free(of_mesh, group):
    pairs = [(of[group], of["free"]) for of in of_mesh.values() if group in of and "free" in of]
    return [a.cpu / b.cpu for a, b in pairs if a.ok and b.ok and a.cpu and b.cpu]


def verdicts(of_mesh):
    rows = []
    for group in NAMES[1:]:
        found = [of[group] for of in of_mesh.values() if group in of]
        flips = sum(int(run.value("flipped_triangles") or 0) for run in found)
        rows.append([f"`{group}`", f"{sum(map(is_met, found))} of {len(found)}", flips,
                     quantiles(over_free(of_mesh, group, "quasi_conformal_mean")),
                     quantiles(over_free(of_mesh, group, "log_area_ratio_l2")),
                     quantiles(seconds_over_free(of_mesh, group))])
    head = ["rotations", "met to 1e-10 rad", "flipped triangles", "qc mean over free", "area over free", "CPU over free"]
    return table(head, rows)


def row(mesh, group, run):
    genus = run.value("handle_rotations")
    values = ["holonomy_miss_start", "holonomy_miss_before", "holonomy_miss", "holonomy_angle_change"]
    return [mesh, f"`{group}`", run.triangles, number(genus and genus / 2, "{:.0f}"), number(run.value("cones"), "{:.0f}"),
            run.outcome, *[number(run.value(name), "{:.1e}") for name in values],
            number(run.value("quasi_conformal_mean"), "{:.4f}"), number(run.value("quasi_conformal_max")),
            number(run.value("log_area_ratio_l2")), number(run.cpu, "{:.1f}")]


def tables(runs):
    of_mesh = by_group(runs)
    rows = [row(mesh, group, of[group]) for mesh, of in of_mesh.items() for group in NAMES if group in of]
    head = ["mesh", "rotations", "triangles", "genus", "cones", "outcome", "miss of first cones", "before closing", "after",
            "angles changed", "qc mean", "qc max", "area l2", "CPU [s]"]
    return "\n\n".join(["# Conformal maps that are seamless up to rotations", verdicts(of_mesh),
                        "Misses are distances [rad] of the rotations along handles to the next multiple: predicted for the first cones, "
                        "finished with the cones found, after the angles closed it; `angles changed`: by that, at most.",
                        table(head, rows, 2)])


def draw(runs, path):
    of_mesh = by_group(runs)
    figure, axis = plt.subplots(figsize=(6, 0.22 * len(of_mesh) + 1.2))
    for y, of in enumerate(of_mesh.values()):
        for group, colour in zip(NAMES, records.COLOURS):
            if group in of and of[group].ok:
                axis.plot([of[group].value("quasi_conformal_mean") - 1], [y], "o", markersize=4, color=colour,
                          label=group if y == 0 else None)
    axis.set_yticks(range(len(of_mesh)), list(of_mesh))
    axis.set(xlabel="quasi_conformal_mean - 1", xscale="log")
    axis.legend()
    records.save(figure, path)

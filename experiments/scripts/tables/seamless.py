"""Rotations along handles that are multiples, beside free ones: what is met, and what it costs."""
from tables import records
from tables.records import number, plt, quantiles, table

OUTPUT = "seamless"
NAMES = ["free", "as many", "halves", "thirds"]
SEAMLESS = NAMES[2:]
GENERA = [(1, 12), (13, 1000)]
ACCURACY = 1e-10  # rad


def by_group(runs):
    """{mesh: {method: run}}, smallest mesh first."""
    return {mesh: {run.group: run for run in runs if run.mesh == mesh} for mesh in records.by_size(runs)}


def is_met(run):
    miss = run.value("holonomy_miss")
    return run.ok and miss is not None and miss <= ACCURACY and run.value("rotation_order") in (4, 6)


def genus(of):
    rotations = of["free"].value("handle_rotations") if "free" in of else None
    return rotations / 2 if rotations else None


def over(of_mesh, group, base, measure):
    """measure of the group's run over that of the run of `base`, on the meshes that have both."""
    pairs = [(of[group], of[base]) for of in of_mesh.values() if group in of and base in of]
    values = [(measure(a), measure(b)) for a, b in pairs if a.ok and b.ok]
    return [a / b for a, b in values if a and b]


def named(value):
    return lambda run: run.value(value)


def verdict(of_mesh, group, name):
    found = [of[group] for of in of_mesh.values() if group in of]
    flips = sum(int(run.value("flipped_triangles") or 0) for run in found)
    ratios = [quantiles(over(of_mesh, group, base, named(value))) for value in ("quasi_conformal_mean", "log_area_ratio_l2")
              for base in ("free", "as many")]
    return [f"`{group}`", name, f"{sum(map(is_met, found))} of {len(found)}", flips, *ratios,
            quantiles(over(of_mesh, group, "free", lambda run: run.cpu))]


def verdicts(of_mesh):
    rows = []
    for least, most in GENERA:
        of_genus = {mesh: of for mesh, of in of_mesh.items() if genus(of) and least <= genus(of) <= most}
        if not of_genus:
            continue
        name = f"{min(map(genus, of_genus.values())):.0f} to {max(map(genus, of_genus.values())):.0f}"
        rows += [verdict(of_genus, group, name) for group in SEAMLESS]
    head = ["rotations", "genus", "met to 1e-10 rad", "flipped triangles", "qc mean over free", "over as many cones",
            "area l2 over free", "over as many cones", "CPU over free"]
    return table(head, rows, 2)


def row(mesh, group, run):
    rotations = run.value("handle_rotations")
    values = ["holonomy_miss_start", "holonomy_miss_before", "holonomy_miss", "holonomy_angle_change"]
    return [mesh, f"`{group}`", run.triangles, number(rotations and rotations / 2, "{:.0f}"), number(run.value("cones"), "{:.0f}"),
            run.outcome, *[number(run.value(name), "{:.1e}") for name in values],
            number(run.value("quasi_conformal_mean"), "{:.4f}"), number(run.value("quasi_conformal_max")),
            number(run.value("log_area_ratio_l2")), number(run.cpu, "{:.1f}")]


def tables(runs):
    of_mesh = by_group(runs)
    rows = [row(mesh, group, of[group]) for mesh, of in of_mesh.items() for group in NAMES if group in of]
    head = ["mesh", "rotations", "triangles", "genus", "cones", "outcome", "miss of first cones", "before closing", "after",
            "angles changed", "qc mean", "qc max", "area l2", "CPU [s]"]
    return "\n\n".join(["# Conformal maps that are seamless up to rotations", verdicts(of_mesh),
                        "`free`: the default's cones; `as many`: as many cones as the rotations are given, of angles of their own. "
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

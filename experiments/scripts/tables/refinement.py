"""Maps as the circle pattern gives them, refined, and with seams let go: distortion and time."""
from tables import records
from tables.records import number, plt, quantiles, shown, table

OUTPUT = "refinement"
REFINED = {"patches": "`auto`", "mips": "`mips`", "mean": "`quasi_conformal`"}
GROUPS = ("plain", *REFINED)


def excess(run):
    return run.value("quasi_conformal_mean") - 1


def pairs(runs, group):
    """(refined, plain) on every mesh that has both."""
    plain = {run.mesh: run for run in runs if run.group == "plain" and run.ok}
    return [(run, plain[run.mesh]) for run in runs if run.group == group and run.ok and run.mesh in plain]


def summary(runs):
    rows = []
    for group, name in REFINED.items():
        both = pairs(runs, group)
        rows.append([name, len(both)] + [quantiles([measure(run) / measure(plain) for run, plain in both]) for measure in
                                         (excess, lambda run: run.value("quasi_conformal_max"), lambda run: run.value("log_area_ratio_l2"),
                                          lambda run: run.cpu)])
    return table(["refinement", "meshes", "qc mean less 1", "qc max", "log area ratio L2", "CPU time"], rows)


def by_mesh(runs):
    rows = []
    for mesh in records.by_size(runs):
        own = {run.group: run for run in runs if run.mesh == mesh}
        if "plain" not in own:
            continue
        maps = [own.get(group) for group in GROUPS]
        rows.append([mesh, own["plain"].triangles] +
                    [shown(run, run and run.value(name), form) for name, form in
                     (("quasi_conformal_mean", "{:.5f}"), ("quasi_conformal_max", "{:.4g}")) for run in maps] +
                    [shown(run, run and run.cpu, "{:.2f}") for run in maps])
    head = [f"{measure} {group}" for measure in ("qc mean", "qc max", "CPU [s]") for group in GROUPS]
    return table(["mesh", "triangles"] + head, rows)


def cones(runs):
    """Runs of equally many cones: seams congruent or free."""
    rows = []
    for run in runs:
        if run.group in ("eight", "eight_open"):
            method = run.method
            rows.append([run.mesh, method["seams"], f"`{method['cones']}`", method["refine_map"]] +
                        [shown(run, run.value(name), form) for name, form in
                         (("cones", "{:.0f}"), ("flipped_triangles", "{:.0f}"), ("quasi_conformal_mean", "{:.4f}"),
                          ("quasi_conformal_max", "{:.3g}"), ("log_area_ratio_l2", "{:.3f}"), ("cut_length", "{:.2f}"))] +
                        [number(run.cpu, "{:.2f}")])
    head = ["mesh", "seams", "cones by", "refinement", "cones", "flips", "qc mean", "qc max", "log area ratio L2", "cut", "CPU [s]"]
    return table(head, rows, 4)


def tables(runs):
    parts = ["# Refinement of finished maps",
             "Refined over plain on the same mesh: median (least to greatest).", summary(runs),
             "## Mesh by mesh", by_mesh(runs)]
    if any(run.group.startswith("eight") for run in runs):
        parts += ["## Eight cones", "Rigid seams: the two sides of every cut are congruent, the metric is flat but for the cones. "
                  "Free: the cones only choose the cut, and what is opened along it gets a free boundary.", cones(runs)]
    return "\n\n".join(parts)


def draw(runs, path):
    meshes = [mesh for mesh in records.by_size(runs) if any(run.mesh == mesh and run.group == "plain" for run in runs)]
    figure, axes = plt.subplots(1, 2, figsize=(8, 0.22 * len(meshes) + 1.2), sharey=True)
    for axis, name, less in ((axes[0], "quasi_conformal_mean", 1), (axes[1], "quasi_conformal_max", 0)):
        for colour, marker, group in zip(records.COLOURS, "ovsD", GROUPS):
            points = [(run.value(name) - less, meshes.index(run.mesh)) for run in runs if run.group == group and run.ok and
                      run.mesh in meshes]
            if points:
                axis.plot(*zip(*points), marker, color=colour, markersize=4, alpha=0.8, label=group)
        axis.set(xlabel=name + (" - 1" if less else ""), xscale="log")
    axes[0].set_yticks(range(len(meshes)), meshes)
    axes[1].legend()
    records.save(figure, path)

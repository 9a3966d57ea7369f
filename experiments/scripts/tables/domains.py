"""Plane, sphere, disk and rectangle: outcome, flips, distortion, time."""
from tables import records
from tables.records import number, plt, quantiles, table

OUTPUT = "domains"


def domain(run):
    return run.method["domain"]


def core_distortion(run):
    """Mean quasi-conformal distortion without the faces that a chord of the disk cuts off: with all corners on the
    circle such a face has no room there, whatever one does."""
    core = run.value("core_quasi_conformal_mean")
    return run.value("quasi_conformal_mean") if core is None else core


def run_rows(runs):
    rows = []
    for mesh in records.by_size(runs):
        for run in (run for run in runs if run.mesh == mesh):
            values = [run.value(name) for name in ("flipped_triangles", "quasi_conformal_mean", "quasi_conformal_max",
                                                   "angle_error_mean", "log_area_ratio_l2")]
            forms = ["{:.0f}", "{:.4f}", "{:.4g}", "{:.4f}", "{:.3f}"]
            rows.append([mesh, domain(run), run.outcome, run.record.get("overlap", ""), run.triangles] +
                        [number(value, form) for value, form in zip(values, forms)] +
                        [number(core_distortion(run), "{:.4f}"), number(run.cpu, "{:.2f}")])
    return rows


def against_plane(runs):
    """What a domain costs against the plane on the same mesh: median (least to greatest)."""
    plane = {run.mesh: run for run in runs if domain(run) == "plane" and run.ok}
    rows = []
    for name in records.in_order(domain(run) for run in runs):
        own = [run for run in runs if domain(run) == name]
        mapped = [run for run in own if run.ok]
        compared = [(run, plane[run.mesh]) for run in mapped if run.mesh in plane]
        rows.append([f"`{name}`", f"{len(mapped)} of {len(own)}",
                     sum(run.value("flipped_triangles") or 0 for run in mapped),
                     quantiles([core_distortion(run) / core_distortion(base) for run, base in compared]),
                     quantiles([run.cpu / base.cpu for run, base in compared])])
    return table(["domain", "mapped", "flipped triangles", "core qc mean over the plane's", "CPU time over the plane's"], rows, 2)


def tables(runs):
    head = ["mesh", "domain", "outcome", "overlap", "triangles", "flips", "qc mean", "qc max", "angle change [rad]",
            "log area ratio L2", "core qc mean", "CPU [s]"]
    return "\n\n".join(["# Domains", against_plane(runs),
                        "On closed surfaces the plane means cones and a cut, on disks a free boundary. \"Core\": without the faces "
                        "that an edge between two boundary vertices cuts off, whose corners the disk puts on its circle.",
                        table(head, run_rows(runs), 4)])


def draw(runs, path):
    meshes = records.by_size(runs)
    figure, axes = plt.subplots(1, 2, figsize=(8, 0.22 * len(meshes) + 1.2), sharey=True)
    measures = [(core_distortion, "core mean quasi-conformal distortion", "linear"),
                (lambda run: run.value("log_area_ratio_l2"), "log area ratio L2", "log")]
    for axis, (measure, label, scale) in zip(axes, measures):
        for colour, marker, name in zip(records.COLOURS, "osD^v<", records.in_order(domain(run) for run in runs)):
            points = [(measure(run), meshes.index(run.mesh)) for run in runs if domain(run) == name and run.ok]
            if points:
                axis.plot(*zip(*points), marker, color=colour, markersize=4, alpha=0.8, label=name)
        axis.set(xlabel=label, xscale=scale)
    axes[0].set_yticks(range(len(meshes)), meshes)
    axes[1].legend()
    records.save(figure, path)

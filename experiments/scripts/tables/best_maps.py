"""The default's maps beside the best that are known of the same vertices."""
from tables import records
from tables.records import number, plt, quantiles, table

OUTPUT = "best_maps"


def energy(run):
    """The objective whose minimum is sought: the mean of q + 1/q - 2, q the quasi-conformal distortion."""
    return run.value("map_refinement_after")


def rows_of(runs):
    """(mesh, default, those taken to rest), of meshes that have both."""
    rows = []
    for mesh in records.by_size(runs):
        own = [run for run in runs if run.mesh == mesh and run.ok]
        default = next((run for run in own if run.group == "default"), None)
        rest = [run for run in own if run.group == "rest" and energy(run) is not None]
        if default and rest:
            rows.append((mesh, default, rest))
    return rows


def tables(runs):
    rows, ratios, spreads = [], [], []
    for mesh, default, rest in rows_of(runs):
        best = min(rest, key=lambda run: run.value("quasi_conformal_mean"))
        least, most = (choose(run.value("quasi_conformal_mean") for run in rest) for choose in (min, max))
        mean = default.value("quasi_conformal_mean")
        ratios.append(mean / least)
        spreads.append(most / least)
        rows.append([mesh, default.triangles, number(mean, "{:.4f}"), number(least, "{:.4f}"), number(most, "{:.4f}"),
                     number(mean / least, "{:.3f}"), number(default.value("quasi_conformal_max"), "{:.3g}"),
                     number(best.value("quasi_conformal_max"), "{:.3g}"), number(best.value("map_refinement_steps"), "{:.0f}"),
                     number(default.cpu, "{:.2f}"), number(best.cpu, "{:.2f}")])
    head = ["mesh", "triangles", "qc mean", "best", "worst rest", "over best", "qc max", "of best", "its steps", "CPU [s]", "of best"]
    return "\n\n".join(["# The best that the vertices of coarse surfaces can do",
                        f"Default over best known: {quantiles(ratios)}. Worst over best of the starts, each taken to rest: "
                        f"{quantiles(spreads)}: near 1, the minimum does not depend on the start.",
                        table(head, rows)])


def draw(runs, path):
    rows = rows_of(runs)
    figure, axis = plt.subplots(figsize=(6, 0.22 * len(rows) + 1.2))
    for y, (_, default, rest) in enumerate(rows):
        axis.plot([run.value("quasi_conformal_mean") - 1 for run in rest], [y] * len(rest), "|", color=records.COLOURS[0])
        axis.plot([default.value("quasi_conformal_mean") - 1], [y], "o", markersize=4, color=records.COLOURS[1])
    axis.set_yticks(range(len(rows)), [mesh for mesh, _, _ in rows])
    axis.set(xlabel="quasi_conformal_mean - 1 (point: the default; strokes: starts taken to rest)", xscale="log")
    records.save(figure, path)

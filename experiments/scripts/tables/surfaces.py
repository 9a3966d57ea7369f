"""Does every surface end in a certified map, whatever its topology?"""
from tables import records
from tables.records import number, plt, power_fit, table

OUTPUT = "surfaces"
COLUMNS = [("cones", "cones", "{:.0f}"), ("seams", "seams", "{:.0f}"), ("flips", "flipped_triangles", "{:.0f}"), ("qc mean", "quasi_conformal_mean", "{:.4f}"),
           ("qc max", "quasi_conformal_max", "{:.4g}"), ("seam gap", "seam_gap", "{:.0e}"), ("gradient", "radii_gradient", "{:.0e}")]
DISTORTED = 2


def verdict(runs):
    good = [run for run in runs if run.ok]
    lost = [f"{run.mesh} ({run.outcome})" for run in runs if not run.ok]
    flipped = [run.mesh for run in good if run.value("flipped_triangles")]
    far = [run.mesh for run in good if run.value("quasi_conformal_mean") > DISTORTED]
    inject = sum(run.record["overlap"] == "injective" for run in good)
    return (f"{len(good)} of {len(runs)} surfaces are mapped" + (f"; the others say why: {', '.join(lost)}" if lost else "") + f". "
            f"{'No map has' if not flipped else ', '.join(flipped) + ' have'} flipped triangles; {inject} maps are injective as they come. "
            f"The mean quasi-conformal distortion is above {DISTORTED} on {len(far)}" + (f": {', '.join(far)}." if far else "."))


def tables(runs):
    rows = []
    for mesh in records.by_size(runs):
        run = next(run for run in runs if run.mesh == mesh)
        rows.append([mesh, run.triangles, run.outcome, run.record["overlap"], number(run.cpu, "{:.2f}")] +
                    [number(run.value(name), text) for _, name, text in COLUMNS])
    question = runs[0].record.get("provenance", {}).get("question", "")
    return "\n\n".join(["# Surfaces of every topology", f"**Question.** {question}", f"**Answer.** {verdict(runs)}",
                        "With the default's cones where a surface is closed, an automatic cut and free boundaries; the quadratic objective, and all else by default.",
                        table(["mesh", "triangles", "outcome", "overlap", "CPU s"] + [name for name, _, _ in COLUMNS], rows)])


def draw(runs, path):
    figure, axis = plt.subplots(figsize=(4.5, 3.4))
    points = [(run.triangles, run.cpu) for run in runs if run.ok and run.cpu]
    if points:
        axis.plot(*zip(*points), "o", color=records.COLOURS[0], markersize=3)
    fit = power_fit(*zip(*points)) if points else None
    axis.set(xscale="log", yscale="log", xlabel="triangles", ylabel="CPU time [s]", title="" if fit is None else f"exponent {fit[0]:.2f}")
    records.save(figure, path)

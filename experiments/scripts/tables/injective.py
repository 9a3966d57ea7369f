"""Images that cover no point twice: by what they are made so, and what that costs."""
from tables import records
from tables.records import number, plt, quantiles, shown, table

OUTPUT = "injective"


def asked(run):
    return bool(run.method.get("injective", False))


def pairs(runs):
    """[(mesh, as it comes, with --injective)], smallest mesh first."""
    found = []
    for mesh in records.by_size(runs):
        plain = next((run for run in runs if run.mesh == mesh and not asked(run)), None)
        injective = next((run for run in runs if run.mesh == mesh and asked(run)), None)
        if plain and injective:
            found.append((mesh, plain, injective))
    return found


def overlaps(run):
    return run.ok and run.record.get("overlap") == "boundary_overlaps"


def made_by(run):
    if not run.ok or run.value("injectivity_stages") is None:
        return "as it comes"
    if run.record.get("overlap") != "injective":
        return "nothing"
    if run.value("boundary_turned") is not None:
        return "curvature"
    return "descent" if run.value("descent_steps") is not None else "charts"


def cost(plain, injective, name):
    before, after = plain.value(name), injective.value(name)
    return None if not before or after is None else after / before


def summary(found):
    rows = []
    for way in ("as it comes", "curvature", "descent", "charts", "nothing"):
        of_way = [(plain, injective) for _, plain, injective in found if injective.ok and made_by(injective) == way]
        if not of_way:
            continue
        both = [(plain, injective) for plain, injective in of_way if plain.ok]
        rows.append([way, len(of_way), sum(1 for plain, _ in of_way if overlaps(plain)),
                     sum(1 for _, injective in of_way if overlaps(injective))]
                    + [quantiles([ratio for ratio in (cost(plain, injective, name) for plain, injective in both) if ratio])
                       for name in ("quasi_conformal_mean", "log_area_ratio_l2", "cut_length")]
                    + [quantiles([injective.cpu / plain.cpu for plain, injective in both])])
    head = ["made injective by", "meshes", "overlapped before", "overlap after", "qc mean", "log area ratio L2", "cut length",
            "CPU time"]
    return table(head, rows)


def tables(runs):
    found = pairs(runs)
    rows = [[mesh, made_by(injective), plain.record.get("overlap", plain.outcome),
             injective.record.get("overlap", injective.outcome), plain.triangles,
             shown(injective, injective.value("charts") or 1, "{:.0f}"),
             number(injective.value("boundary_turned"), "{:.2f}"),
             number(plain.value("overlap_area"), "{:.3f}"),
             number(plain.value("quasi_conformal_mean"), "{:.4f}"), number(injective.value("quasi_conformal_mean"), "{:.4f}"),
             number(plain.value("log_area_ratio_l2"), "{:.3f}"), number(injective.value("log_area_ratio_l2"), "{:.3f}"),
             number(plain.value("cut_length"), "{:.2f}"), number(injective.value("cut_length"), "{:.2f}"),
             number(plain.cpu, "{:.2f}"), number(injective.cpu, "{:.2f}")] for mesh, plain, injective in found]
    head = ["mesh", "made by", "before", "after", "triangles", "charts", "turned [rad]", "overlap area", "qc mean", "after",
            "log area L2", "after", "cut", "after", "CPU [s]", "after"]
    return "\n\n".join(["# Injective images",
                        "Over the map as it comes: median (least to greatest). \"Overlap area\": the part of the image, as it comes, "
                        "that covers what is covered already. Cut lengths are over the square root of the area.",
                        summary(found), table(head, rows, 4)])


def draw(runs, path):
    found = [(mesh, plain, injective) for mesh, plain, injective in pairs(runs) if overlaps(plain) and injective.ok]
    figure, axes = plt.subplots(1, 2, figsize=(8, 0.22 * max(len(found), 1) + 1.2), sharey=True)
    for place, (name, label) in zip(axes, (("log_area_ratio_l2", "log area ratio L2"), ("cut_length", "cut length"))):
        place.plot([plain.value(name) or 0 for _, plain, _ in found], range(len(found)), "o", mfc="none", label="as it comes")
        place.plot([injective.value(name) or 0 for _, _, injective in found], range(len(found)), "x", label="--injective")
        place.set_xlabel(label)
    axes[0].set_yticks(range(len(found)), [mesh for mesh, _, _ in found])
    axes[1].legend()
    records.save(figure, path)

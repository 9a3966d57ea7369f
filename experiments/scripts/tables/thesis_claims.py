"""What the thesis says of its method, claim by claim, on meshes that it did not see."""
import statistics

from tables import records
from tables.records import median_interval, plt, table

OUTPUT = "thesis_claims"
LEAST = 1e-5  # below it there is no distortion: ratios of such say nothing
SIMILAR = 1.1
EASILY = 10
HOLDS = 2 / 3  # the share of the meshes that a claim must hold on
NAMED = 12


def distortion(run):
    return run.value("quasi_conformal_mean") - 1


def area(run):
    return run.value("log_area_ratio_l2")


def closure(run):
    return run.value("layout_closure")


# Two methods, what is compared, and whether the second is as the first or has less of it.
CLAIMS = [
    ("The quadratic program and the nonlinear energy give similar maps", "thesis", "nonlinear", distortion, "similar"),
    ("Delaunay input lowers distortion", "raw", "thesis", distortion, "less"),
    ("Cones lower area distortion", "thesis", "cones", area, "less"),
    ("One range of angles for all cones gives more area distortion than angles of their own", "ranges", "cones", area, "less"),
    ("The accuracy of the layout can be improved", "thesis", "least_squares", closure, "less"),
]


def mapped(runs, method):
    return {run.mesh: run for run in runs if run.group == method and run.ok}


def has_boundary(run):
    """Without cones only surfaces with a boundary have a map."""
    return not run.value("cones")


def ratios(runs, first, second, measure):
    """{mesh: second / first} where both have a map and a measure; of cones against none only where there are none."""
    a, b = mapped(runs, first), mapped(runs, second)
    meshes = [mesh for mesh in records.by_size(runs) if mesh in a and mesh in b]
    if (first, second) == ("thesis", "cones"):
        meshes = [mesh for mesh in meshes if has_boundary(a[mesh])]
    found = {mesh: (measure(a[mesh]), measure(b[mesh])) for mesh in meshes}
    least = 0 if measure is closure else LEAST
    return {mesh: y / x for mesh, (x, y) in found.items() if x is not None and y is not None and x > least and y > 0}


def agrees(ratio, kind):
    return 1 / SIMILAR <= ratio <= SIMILAR if kind == "similar" else ratio < 1


def verdict(agreeing, count, interval, kind):
    """Holds: on two of three meshes, and beyond chance in the median."""
    if count == 0:
        return "not tested"
    least, greatest = interval
    median = 1 / SIMILAR <= least and greatest <= SIMILAR if kind == "similar" else greatest < 1
    if agreeing >= HOLDS * count and median:
        return "holds"
    return "does not hold" if agreeing <= (1 - HOLDS) * count else "undecided"


def names(meshes):
    more = f" and {len(meshes) - NAMED} more" if len(meshes) > NAMED else ""
    return ", ".join(meshes[:NAMED]) + more or "none"


def compared(runs):
    rows = []
    for title, first, second, measure, kind in CLAIMS:
        found = ratios(runs, first, second, measure)
        interval = median_interval(list(found.values())) if found else (0, 0)
        agreeing = [mesh for mesh, ratio in found.items() if agrees(ratio, kind)]
        against = sorted((mesh for mesh in found if mesh not in agreeing), key=lambda mesh: -abs(found[mesh]))
        middle = f"{statistics.median(found.values()):.3g} ({interval[0]:.3g} to {interval[1]:.3g})" if found else "-"
        rows.append([title, f"`{second}` / `{first}`, {measure.__name__}", middle, f"{len(agreeing)} of {len(found)}",
                     f"**{verdict(len(agreeing), len(found), interval, kind)}**", names(against)])
    return rows


def counted(runs, title, figure, good, bad):
    """A row of a claim on single runs."""
    count = len(good) + len(bad)
    word = "not tested" if count == 0 else "holds" if len(good) >= 0.95 * count else "does not hold"
    return [title, figure, "", f"{len(good)} of {count}", f"**{word}**", names(bad)]


def existence(runs):
    own = [run for run in runs if run.group == "thesis" and run.outcome != "invalid_input"]
    good = [run.mesh for run in own if run.outcome != "infeasible"]
    bad = [run.mesh for run in own if run.outcome == "infeasible"]
    return counted(runs, "Coherent angles exist", "feasible, `thesis`", good, bad)


def newton(runs):
    steps = {run.mesh: run.value("radii_iterations") for run in runs if run.group == "thesis" and run.ok}
    failed = [run.mesh for run in runs if run.group == "thesis" and run.outcome == "not_converged"]
    good = [mesh for mesh, count in steps.items() if count is not None and count <= EASILY]
    bad = failed + [mesh for mesh, count in steps.items() if count is not None and count > EASILY]
    title = "Newton's method finds the minimum of the circle pattern energy easily"
    return counted(runs, title, f"at most {EASILY} steps, `thesis`", good, bad)


def tables(runs):
    rows = [existence(runs), newton(runs), *compared(runs)]
    held = sum(row[4] == "**holds**" for row in rows)
    head = ["claim", "compared", "median ratio (95 %)", "meshes that agree", "verdict", "that disagree, farthest first"]
    return "\n\n".join([
        "# The thesis's claims",
        f"{held} of {len(rows)} hold on {len({run.mesh for run in runs})} surfaces. A claim holds where two of three meshes agree and "
        "the median ratio of the two methods is on its side at 95 % of confidence (order statistics); existence and convergence, where 95 % "
        f"do. Similar is within {round(100 * (SIMILAR - 1))} %. Distortion is the mean quasi-conformal distortion less 1, area the L2 norm of the log area ratio, "
        "closure the layout's largest misfit.", table(head, rows, texts=len(head))])


def draw(runs, path):
    figure, axis = plt.subplots(figsize=(6, 4))
    for colour, (title, first, second, measure, _) in zip(records.COLOURS, CLAIMS):
        values = sorted(ratios(runs, first, second, measure).values())
        if values:
            axis.step(values, [(i + 1) / len(values) for i in range(len(values))], where="post", color=colour,
                      label=f"{second} / {first}, {measure.__name__}")
    axis.axvline(1, color="#888888", linewidth=0.8)
    axis.set(xscale="log", xlabel="ratio on one mesh", ylabel="share of the meshes", xlim=(1e-2, 1e2))
    axis.legend()
    records.save(figure, path)

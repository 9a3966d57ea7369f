"""Area distortion and time against the number of cones, every heuristic."""
import statistics

from tables import records
from tables.records import median_interval, number, plt, table

OUTPUT = "cones"
METHODS = ["curvature_peaks", "greedy", "l1", "reweighted", "moving", "refined", "angle"]
BASE = "greedy"
STARTS = {"moving": "greedy", "refined": "moving", "angle": "greedy"}
SAME = 1e-3  # relative: what is no difference
SHOWN = 8    # the budget whose meshes are listed


def budget(run):
    return run.method["cone_budget"]


def area(run):
    return run.value("log_area_ratio_l2")


def stretch(run):
    return run.value("quasi_conformal_mean") - 1


def cpu(run):
    return run.cpu


def mapped(runs):
    """{(mesh, method, budget): run}; without cones the budget is 0."""
    return {(run.mesh, run.group, 0 if run.group == "none" else budget(run)): run for run in runs if run.ok}


def budgets(runs):
    return sorted({budget(run) for run in runs if run.group != "none"})


def with_interval(values):
    if not values:
        return "-"
    low, high = median_interval(values)
    return f"{statistics.median(values):.3g} ({low:.3g} to {high:.3g})"


def ratios(found, method, other, size, measure):
    """measure of the method over that of the other, on every mesh that both map."""
    pairs = [(run, found[mesh, other, size]) for (mesh, name, cones), run in found.items()
             if name == method and cones == size and (mesh, other, size) in found]
    values = [(measure(a), measure(b)) for a, b in pairs]
    return [a / b for a, b in values if a and b and a > 0 and b > 0]


def against_none(found, method, size):
    """Area distortion over that of the map without cones."""
    values = [(area(run), area(found[mesh, "none", 0])) for (mesh, name, cones), run in found.items()
              if name == method and cones == size and (mesh, "none", 0) in found]
    return [a / b for a, b in values if b and b > 1e-5]


def common(found, size):
    """The meshes that every heuristic maps with that many cones."""
    return [mesh for mesh in records.in_order(mesh for mesh, _, _ in found)
            if all((mesh, method, size) in found for method in METHODS)]


def best(found, size, measure):
    """{method: meshes on which none has less}, of those that all map."""
    wins = dict.fromkeys(METHODS, 0)
    for mesh in common(found, size):
        values = {method: measure(found[mesh, method, size]) for method in METHODS}
        least = min(values.values())
        for method, value in values.items():
            wins[method] += value <= (1 + SAME) * least
    return wins


def size_table(runs, found, size):
    wins = best(found, size, area)
    everywhere = common(found, size)
    rows = []
    for method in METHODS:
        own = [run for (_, name, cones), run in found.items() if name == method and cones == size]
        tried = sum(run.group == method and budget(run) == size for run in runs)
        rows.append([f"`{method}`", f"{len(own)} of {tried}", number(statistics.median([area(run) for run in own]) if own else None, "{:.4f}"),
                     with_interval(ratios(found, method, BASE, size, area)), f"{wins[method]} of {len(everywhere)}",
                     with_interval(against_none(found, method, size)), with_interval(ratios(found, method, BASE, size, stretch)),
                     number(statistics.median([run.cpu for run in own]) if own else None), with_interval(ratios(found, method, BASE, size, cpu))])
    return table(["heuristic", "maps", "area distortion", f"over `{BASE}` (95 %)", "least on", "over no cones", f"qc - 1 over `{BASE}`",
                  "CPU s", f"CPU over `{BASE}`"], rows)


def improvement(runs, found, method, measure):
    """How often a method has less of the measure than its start, and where it has not."""
    gains, worse, same = [], [], 0
    for size in budgets(runs):
        for mesh in records.by_size(runs):
            if (mesh, method, size) in found and (mesh, STARTS[method], size) in found:
                after, before = measure(found[mesh, method, size]), measure(found[mesh, STARTS[method], size])
                if before <= 0:
                    continue
                gains.append(after / before)
                if after > (1 + SAME) * before:
                    worse.append((after / before, f"{mesh} {size}"))
                elif after > (1 - SAME) * before:
                    same += 1
    if not gains:
        return f"`{method}` has no pairs to compare."
    worse.sort(reverse=True)
    named = ", ".join(f"{name} ({ratio:.3g} times)" for ratio, name in worse[:5]) + (", ..." if len(worse) > 5 else "")
    return (f"`{method}` has {with_interval(gains)} times the figure of its start `{STARTS[method]}` (median of {len(gains)}; {min(gains):.3g} to "
            f"{max(gains):.3g}); no different within a thousandth on {same}, worse on {len(worse)}" + (f": {named}." if worse else "."))


def verdict(runs, found):
    said = []
    for size in budgets(runs):
        wins = best(found, size, area)
        first = max(METHODS, key=lambda method: wins[method])
        fall = against_none(found, first, size)
        left = f", {statistics.median(fall):.2g} of the distortion without cones" if fall else ""
        said.append(f"with {size} cones `{first}` has the least area distortion on {wins[first]} of {len(common(found, size))} meshes{left}, "
                    f"for {statistics.median(ratios(found, first, BASE, size, cpu)):.2g} times the CPU time of `{BASE}`")
    return "On " + str(len({run.mesh for run in runs})) + " meshes: " + "; ".join(said) + "."


def mesh_table(runs, found):
    everything = {(run.mesh, run.group, budget(run)): run for run in runs if run.group != "none"}
    rows = []
    for mesh in records.by_size(runs):
        none = found.get((mesh, "none", 0))
        own = [found.get((mesh, method, SHOWN)) for method in METHODS]
        if not any(own):
            continue
        least = min(area(run) for run in own if run)
        cells = []
        for method, run in zip(METHODS, own):
            other = everything.get((mesh, method, SHOWN))
            text = f"{area(run):.4f}" if run else other.outcome if other else ""
            cells.append(f"**{text}**" if run and area(run) <= (1 + SAME) * least else text)
        rows.append([mesh, number(none and area(none), "{:.4f}")] + cells)
    return table(["mesh", "no cones"] + METHODS, rows)


def tables(runs):
    found = mapped(runs)
    question = runs[0].record.get("provenance", {}).get("question", "")
    text = ["# Cones by every heuristic", f"**Question.** {question}", f"**Answer.** {verdict(runs, found)}", "![Area distortion and time against cones](cones.svg)",
            "All figures are of the realised map on the input's triangles, not of a linear prediction: area distortion is the L2 norm of the "
            "logarithm of the area ratio. `refined`: `moving` with up to four steps on the cones' angles. `angle`: `moving:measure=angle`, which "
            "lowers the predicted mean quasi-conformal distortion instead of area distortion. Medians over the meshes that the heuristic maps, ratios "
            "over the meshes that both map, with the 95 % interval of the median; *least on*: of the meshes that every heuristic maps, those on "
            "which none has less by a thousandth. Without a map are surfaces whose curvature so few cones cannot carry."]
    for size in budgets(runs):
        text += [f"## {size} cones", size_table(runs, found, size)]
    text += ["## Does a heuristic improve on its start?", "In area distortion: " + " ".join(improvement(runs, found, name, area) for name in ("moving", "refined")),
             "In mean quasi-conformal distortion less 1: " + improvement(runs, found, "angle", stretch),
             f"## Area distortion with {SHOWN} cones, mesh by mesh", mesh_table(runs, found)]
    return "\n\n".join(text)


def draw(runs, path):
    found = mapped(runs)
    sizes = budgets(runs)
    everywhere = [mesh for mesh in records.by_size(runs) if all((mesh, method, size) in found for method in METHODS for size in sizes)]
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.6))
    for axis, label, measure in zip(axes, ["L2 of the log area ratio", "CPU time [s]"], [area, cpu]):
        for colour, marker, method in zip(records.COLOURS + ["#333333"], "os^Dv<>", METHODS):
            values = [[measure(found[mesh, method, size]) for mesh in everywhere] for size in sizes]
            if everywhere:
                axis.plot(sizes, [statistics.median(own) for own in values], marker + "-", color=colour, markersize=3, linewidth=1, label=method)
        axis.set_xscale("log", base=2)
        axis.set(yscale="log", xlabel="cones", ylabel=label, title=f"medians of {len(everywhere)} meshes")
        axis.legend(fontsize=6)
    records.save(figure, path)

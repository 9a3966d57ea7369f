"""Do the maps converge to smooth conformal maps, and at which order in the edge length?"""
import re
import statistics

from tables import records
from tables.records import median_interval, number, plt, power_fit, table

OUTPUT = "convergence"
KINDS = {
    "known map, its boundary angles": "the smooth map is known, and the boundary has its angles",
    "known map, free boundary": "the smooth map is known, no boundary is asked for",
    "known map, isometric boundary": "the smooth map is known, and the boundary's lengths stay as they are",
    "smooth limit": "Loop-refined towards a surface whose smooth map is not known: distance from the map of the next refinement",
}
FIRST, SECOND = 0.75, 1.75  # an order from there on is called first, second


def source(run):
    return run.record["mesh"]["source"]


def kind(run):
    if run.value("refined_map_rms_error") is not None:
        return "smooth limit"
    if run.value("known_map_rms_error") is None:
        return None
    if "boundary=known_map" in source(run):
        return "known map, its boundary angles"
    return "known map, isometric boundary" if run.group == "isometric" else "known map, free boundary"


def error(run, norm):
    return run.value(f"{'refined' if kind(run) == 'smooth limit' else 'known'}_map_{norm}_error")


def method(run):
    return f"{run.group}, {run.method['angle_objective']}"


def seed(run):
    found = re.search(r"seed=\d+", source(run))
    return found[0] if found else ""


def chains(runs):
    """{(kind, method): [runs of one surface, coarse to fine]}, of three and more."""
    found = {}
    for run in runs:
        if run.ok and kind(run) and (error(run, "rms") or 0) > 0:
            found.setdefault((kind(run), method(run)), {}).setdefault((run.family, seed(run)), []).append(run)
    return {key: [sorted(own, key=lambda run: -run.value("edge_length")) for own in of.values() if len(own) >= 3]
            for key, of in found.items()}


def order(chain, measure):
    """The exponent of the measure over the edge length."""
    fit = power_fit([run.value("edge_length") for run in chain], [measure(run) for run in chain])
    return None if fit is None else fit[0]


def orders(of, measure):
    return [value for value in (order(chain, measure) for chain in of) if value is not None]


def with_interval(values):
    if not values:
        return "-"
    low, high = median_interval(values)
    return f"{statistics.median(values):.2f} ({low:.2f} to {high:.2f})"


def rms(run):
    return error(run, "rms")


def largest(run):
    return error(run, "max")


def excess(run):
    return run.value("quasi_conformal_mean") - 1


MEASURES = {"rms distance": rms, "largest distance": largest, "mean qc - 1": excess}


def falls(of):
    """Chains whose finest map is nearer than their coarsest."""
    return sum(rms(chain[-1]) < rms(chain[0]) for chain in of)


def order_table(found):
    rows = []
    for (name, way), of in found.items():
        if not of:
            continue
        finest = [rms(chain[-1]) for chain in of]
        rows.append([name, f"`{way}`", len(of)] + [with_interval(orders(of, measure)) for measure in MEASURES.values()] +
                    [f"{falls(of)} of {len(of)}", number(statistics.median(finest), "{:.2e}")])
    return table(["what is known", "method", "surfaces"] + [f"order of {name} (95 %)" for name in MEASURES] +
                 ["nearer in the end", "rms at the finest"], rows, 2)


def word(value):
    return "second order" if value >= SECOND else "first order" if value >= FIRST else "no first order"


def verdict(found):
    said = []
    for name in KINDS:
        of = {way: orders(own, rms) for (other, way), own in found.items() if other == name and own}
        of = {way: values for way, values in of.items() if values}
        if not of:
            continue
        middles = {way: statistics.median(values) for way, values in of.items()}
        least, most = min(middles, key=middles.get), max(middles, key=middles.get)
        chains_of = [chain for (other, _), own in found.items() if other == name for chain in own]
        said.append(f"{name}: {word(middles[least])} at least, the median order in the mean square is {middles[least]:.2f} (`{least}`) to "
                    f"{middles[most]:.2f} (`{most}`), and {falls(chains_of)} of {len(chains_of)} sequences come nearer")
    return ". ".join(text[0].upper() + text[1:] for text in said) + "."


def surface_table(found):
    """The orders by kind of surface, of the free maps with each objective."""
    rows = []
    for (name, way), of in found.items():
        by_family = {}
        for chain in of:
            by_family.setdefault(chain[0].family, []).append(chain)
        for family, own in by_family.items():
            finest = own[0][-1]
            rows.append([name, family, f"`{way}`", len(own), f"{own[0][0].triangles} to {finest.triangles}",
                         *[number(statistics.median(orders(own, measure)) if orders(own, measure) else None, "{:.2f}") for measure in MEASURES.values()],
                         number(statistics.median(rms(chain[-1]) for chain in own), "{:.2e}")])
    return table(["what is known", "surface", "method", "sequences", "triangles"] + [f"order of {name}" for name in MEASURES] + ["rms at the finest"], rows, 3)


def tables(runs):
    found = chains(runs)
    surfaces = {(chain[0].family, seed(chain[0])) for of in found.values() for chain in of}
    question = runs[0].record.get("provenance", {}).get("question", "")
    text = ["# Convergence to smooth conformal maps", f"**Question.** {question}",
            f"**Answer.** On {len(surfaces)} surfaces, each refined at least twice. {verdict(found)}", "![Distance against edge length](convergence.svg)",
            "Distances are root mean squares and maxima at the vertices after the best similarity, relative to the image's diameter. The order is the "
            "exponent of the edge length by least squares of the logarithms, for every surface by itself; medians over the surfaces with their 95 % "
            "interval. No map is refined afterwards: these are circle patterns. Of a smooth limit the distance from the next refinement's map is "
            "measured, which falls at the order at which the maps converge."]
    text += [f"*{name}*: {meaning}." for name, meaning in KINDS.items()]
    text += ["## Orders", order_table(found), "## By surface", surface_table(found)]
    return "\n\n".join(text)


def draw(runs, path):
    found = chains(runs)
    figure, axes = plt.subplots(1, len(KINDS), figsize=(3.4 * len(KINDS), 3.2), sharey=True)
    for axis, name in zip(axes, KINDS):
        ways = [way for other, way in found if other == name]
        for colour, way in zip(records.COLOURS, ways):
            for i, chain in enumerate(found[name, way]):
                axis.plot([run.value("edge_length") for run in chain], [rms(run) for run in chain], "-", color=colour, linewidth=0.5, alpha=0.5,
                          label=way if i == 0 else None)
        axis.set(xscale="log", yscale="log", title=name, xlabel="edge length")
        if ways:
            axis.legend(fontsize=6)
    axes[0].set_ylabel("rms distance")
    records.save(figure, path)

"""Moduli of rings, tori and rectangles under refinement, and how round round holes are."""
import math
import statistics

from tables import records
from tables.records import number, plt, table

OUTPUT = "moduli"

# What is known of the generators' surfaces: their formulas are in framework/cirque/generators/generators.h.
KNOWN = {
    "annulus": ("`annulus`: concentric circles of radii 0.4 and 1", math.log(1 / 0.4) / (2 * math.pi)),
    "eccentric_annulus": ("`eccentric_annulus`: the unit circle and radius 0.3 about (0.4, 0)",
                          math.acosh((1 + 0.3**2 - 0.4**2) / (2 * 0.3)) / (2 * math.pi)),
    "catenoid": ("`catenoid`: abs(z) <= 1.2", 2.4 / (2 * math.pi)),
    "torus": ("`torus` of revolution, radii 1 and 0.4", complex(0, math.sqrt(1 / 0.4**2 - 1))),
}
SMOOTHED = [
    ("loop_terrain", "rectangle", "conformal_modulus", "terrain to a rectangle: its modulus"),
    ("loop_ring", "annulus", "annulus_modulus", "ring to an annulus: its modulus"),
    ("loop_terrain", "rectangle", "quasi_conformal_mean", "terrain to a rectangle: qc mean"),
    ("loop_terrain", "disk", "quasi_conformal_mean", "terrain to the disk: qc mean"),
    ("loop_ring", "annulus", "quasi_conformal_mean", "ring to an annulus: qc mean"),
]


def family(run):
    return run.record["mesh"]["family"]


def found(run):
    if family(run) == "torus":
        return complex(run.value("modulus_real"), run.value("modulus_imaginary"))
    return run.value("annulus_modulus")


def by_triangles(runs):
    """Runs of one size together: sizes differ by a triangle or two."""
    sizes = {}
    for run in sorted(runs, key=lambda run: run.triangles):
        near = next((size for size in sizes if abs(size - run.triangles) < 0.02 * size), run.triangles)
        sizes.setdefault(near, []).append(run)
    return sizes


def errors(runs, name):
    """(triangles, median relative error, runs, runs with a map) of a surface whose modulus is known."""
    known = KNOWN[name][1]
    rows = []
    for size, own in by_triangles(run for run in runs if family(run) == name).items():
        ok = [run for run in own if run.ok]
        if ok:
            rows.append((size, statistics.median(abs(found(run) / known - 1) for run in ok), len(own), len(ok)))
    return rows


def order(sizes, values):
    """The observed order in the edge length, from one size to the next; None at the first."""
    orders = [None]
    for (n, m), (e, f) in zip(zip(sizes, sizes[1:]), zip(values, values[1:])):
        orders.append(math.log(e / f) / math.log(math.sqrt(m / n)) if e > 0 and f > 0 else None)
    return orders


def known_rows(runs):
    rows = []
    for name, (words, known) in KNOWN.items():
        of_name = errors(runs, name)
        orders = order([row[0] for row in of_name], [row[1] for row in of_name])
        exact = f"{known.imag:.6f} i" if isinstance(known, complex) else f"{known:.6f}"
        for (size, error, own, ok), observed in zip(of_name, orders):
            rows.append([words, exact, size, f"{ok} of {own}", number(error, "{:.2e}"), number(observed, "{:.2f}")])
            words = exact = ""
    return rows


def smoothed(runs, name, domain, key):
    own = sorted((run for run in runs if family(run) == name and run.method["domain"] == domain and run.ok),
                 key=lambda run: run.triangles)
    return [(run.triangles, run.value(key)) for run in own]


def smoothed_rows(runs):
    """The limit of a mean distortion is 1; that of a modulus is not known, so that differences tell the order."""
    rows = []
    for name, domain, key, words in SMOOTHED:
        values = smoothed(runs, name, domain, key)
        sizes = [size for size, _ in values]
        if key == "quasi_conformal_mean":
            misses = [value - 1 for _, value in values]
            orders = order(sizes, misses)
        else:
            misses = [None] + [abs(b - a) for (_, a), (_, b) in zip(values, values[1:])]
            orders = [None] + order(sizes[1:], misses[1:])
        for (size, value), miss, observed in zip(values, misses, orders):
            rows.append([words, size, number(value, "{:.6f}"), number(miss, "{:.2e}"), number(observed, "{:.2f}")])
            words = ""
    return rows


def plate_rows(runs):
    rows = []
    for size, own in by_triangles(run for run in runs if family(run) == "plate_with_holes").items():
        ok = [run for run in own if run.ok]

        def median(name):
            return statistics.median(run.value(name) for run in ok)

        if ok:
            rows.append([size, f"{len(ok)} of {len(own)}", number(max(run.value("roundness") for run in ok), "{:.1e}"),
                         number(max(run.value("circle_error") for run in ok), "{:.1e}"),
                         number(median("round_hole_rounds"), "{:.0f}"), number(median("quasi_conformal_mean") - 1, "{:.2e}"),
                         number(median("smallest_hole_radius"), "{:.4f}"),
                         number(median("largest_hole_radius"), "{:.4f}"), number(statistics.median(run.cpu for run in ok), "{:.2f}")])
    return rows


def tables(runs):
    return "\n\n".join([
        "# Moduli and round holes",
        "Against closed forms: median relative error over three meshes of a size. Order: observed, in the edge length.",
        table(["surface", "modulus", "triangles", "maps", "relative error", "order"], known_rows(runs), 2),
        "Loop's subdivision, level by level, of a catenoid of 500 triangles and a bumpy terrain of 500. The limit surface's modulus has "
        "no closed form: \"miss\" is the difference from the level before, of a mean quasi-conformal distortion what it is above 1.",
        table(["what", "triangles", "value", "miss", "order"], smoothed_rows(runs), 1),
        "A plate with five elliptic holes to the unit disk with five round ones. \"Laid out\": the largest distance of a boundary "
        "vertex from its circle over the circle's radius, as the circle pattern has it; \"placed\": once it was put there.",
        table(["triangles", "maps", "laid out", "placed", "rounds", "qc mean - 1", "smallest hole", "largest hole", "CPU [s]"],
              plate_rows(runs), 1)])


def draw(runs, path):
    figure, axes = plt.subplots(1, 2, figsize=(8, 3))
    for colour, (name, (words, _)) in zip(records.COLOURS, KNOWN.items()):
        points = [(size, error) for size, error, _, _ in errors(runs, name)]
        if points:
            axes[0].plot(*zip(*points), "o-", color=colour, markersize=3, label=name)
    for colour, (name, domain, key, words) in zip(records.COLOURS, SMOOTHED[2:]):
        points = [(size, value - 1) for size, value in smoothed(runs, name, domain, key)]
        if points:
            axes[1].plot(*zip(*points), "o-", color=colour, markersize=3, label=words.split(":")[0])
    axes[0].set(xscale="log", yscale="log", xlabel="triangles", ylabel="relative error of the modulus")
    axes[1].set(xscale="log", yscale="log", xlabel="triangles", ylabel="mean quasi-conformal distortion - 1")
    for axis in axes:
        axis.legend()
    records.save(figure, path)

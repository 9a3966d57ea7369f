"""Cuts by every heuristic, towards cones, and into charts: how long, how visible, how distorted, how well packed."""
import statistics

from tables import records
from tables.records import by_choice, plt, quantiles, table, value_table

OUTPUT = "cuts"
REFERENCE = "rigid, flat_length"
LEAST = 1e-9  # of a value that others are compared with
# What a choice is judged by: the value's name, its head in tables, its format; the less the better but for the last.
FIGURES = [("cut_length", "cut length", "{:.2f}"), ("visible_cut_length", "visible cut length", "{:.2f}"),
           ("quasi_conformal_mean", "qc mean", "{:.4f}"), ("log_scale_l2", "log scale L2", "{:.3f}"),
           ("area_used", "area used", "{:.3f}")]


def choice(run):
    """What was asked for."""
    if run.group == "charts":
        return f"{run.method['least_charts']} charts"
    if run.group == "towards":
        return f"free, towards {run.method['cone_budget']} cones"
    return f"{run.group}, {run.method['cut_cost']}"


def pairs(of_mesh, name, other=REFERENCE):
    """The runs of both choices, on the meshes that both map."""
    both = [(of[name], of[other]) for of in of_mesh.values() if name in of and other in of]
    return [(a, b) for a, b in both if a.ok and b.ok]


def ratios(of_mesh, name, value, other=REFERENCE):
    """Of the two values, where there is something to compare with: a surface that comes out flat without distortion has none."""
    both = [(a.value(value), b.value(value)) for a, b in pairs(of_mesh, name, other)]
    return [a / b for a, b in both if a is not None and b is not None and b > LEAST]


def median_ratio(of_mesh, name, value, other=REFERENCE):
    found = ratios(of_mesh, name, value, other)
    return statistics.median(found) if found else None


def best(of_mesh, names, value, sign=1):
    """Of the choices the one of least (sign 1) or largest median ratio, and that ratio."""
    found = [(sign * median_ratio(of_mesh, name, value), name) for name in names if ratios(of_mesh, name, value)]
    if not found:
        raise records.BadRecords(f"no run tells of {value}")
    least, name = min(found)
    return name, sign * least


def verdict(of_mesh, names):
    seen, seen_ratio = best(of_mesh, [n for n in names if n.startswith("rigid")], "visible_cut_length")
    longer = median_ratio(of_mesh, seen, "cut_length")
    free = [n for n in names if n.startswith("free")]
    lengths, lengths_ratio = best(of_mesh, free, "log_scale_l2")
    longer_free = median_ratio(of_mesh, lengths, "cut_length")
    injective = sum(1 for of in of_mesh.values() if lengths in of and of[lengths].record.get("overlap") == "injective")
    angles, angles_ratio = best(of_mesh, free + [n for n in names if n.endswith("charts")], "quasi_conformal_mean")
    filled, filled_ratio = best(of_mesh, names, "area_used", -1)
    return (f"Over `{REFERENCE}`, in the median of {len(of_mesh)} closed surfaces: with seams that match `{seen}` is seen least, "
            f"{seen_ratio:.2f} of the visible length for {longer:.2f} times the length; of single images with free seams `{lengths}` leaves "
            f"least area distortion, {lengths_ratio:.2f} of the L2 norm of the log scale, for {longer_free:.2f} times the length ({injective} of "
            f"them injective); `{angles}` has the least mean "
            f"quasi-conformal distortion ({angles_ratio:.3f}), and `{filled}` fills most of its square ({filled_ratio:.2f} times the area).")


def summary(of_mesh, names):
    rows = []
    for name in names:
        found = [of[name] for of in of_mesh.values() if name in of]
        mapped = [run for run in found if run.ok]
        patches = [run.value("patches") for run in mapped if run.value("patches") is not None]
        injective = sum(1 for run in mapped if run.record.get("overlap") == "injective")
        rows.append([f"`{name}`", f"{len(mapped)} of {len(found)}", f"{min(patches):.0f} to {max(patches):.0f}" if patches else "-"]
                    + [quantiles(ratios(of_mesh, name, value)) for value, _, _ in FIGURES]
                    + [injective, quantiles([a.cpu / b.cpu for a, b in pairs(of_mesh, name) if a.cpu and b.cpu])])
    head = ["cut", "maps", "charts"] + [head for _, head, _ in FIGURES] + ["injective", "CPU time"]
    return table(head, rows, 3)


def tables(runs):
    of_mesh = by_choice(runs, choice)
    names = records.in_order(choice(run) for run in runs)
    question = runs[0].record.get("provenance", {}).get("question", "")
    text = ["# Cuts", f"**Question.** {question}", f"**Answer.** {verdict(of_mesh, names)}",
            "![Medians of every cut](cuts.svg)",
            "Lengths are over the square root of the surface's area; in the visible one every edge counts by the share of directions from "
            f"which it is seen (64; of long cuts fewer for an edge, each others than the next); \"area used\" is the share of its bounding square that a map covers. Over `{REFERENCE}` on the same mesh: "
            "median (least to greatest).", summary(of_mesh, names)]
    for value, head, form in FIGURES:
        text += [f"## {head[0].upper() + head[1:]}", value_table(of_mesh, names, value, form)]
    return "\n\n".join(text)


def draw(runs, path):
    of_mesh = by_choice(runs, choice)
    names = records.in_order(choice(run) for run in runs)[::-1]
    figure, axis = plt.subplots(figsize=(6, 0.24 * len(names) + 1))
    for (value, head, _), marker, colour in zip(FIGURES, "o^sDv", records.COLOURS):
        found = [(median_ratio(of_mesh, name, value), place) for place, name in enumerate(names)]
        axis.plot(*zip(*[(ratio, place) for ratio, place in found if ratio]), marker, color=colour, markersize=4.5, label=head)
    axis.axvline(1, color="0.4", linewidth=0.8)
    axis.set_yticks(range(len(names)), names)
    axis.set(xlabel=f"median over {REFERENCE}", xscale="log")
    axis.legend(loc="center left", bbox_to_anchor=(1, 0.5))
    records.save(figure, path)

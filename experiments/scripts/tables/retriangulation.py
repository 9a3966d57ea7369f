"""The loop of locked edges alone and after flips of active edges."""
from tables import records
from tables.records import number, plt, quantiles, shown, table

OUTPUT = "retriangulation"


def pairs(runs):
    """(mesh, run without flips, run with), None where there is none."""
    found = []
    for mesh in records.by_size(runs):
        own = {run.method["retriangulate"] > 0: run for run in runs if run.mesh == mesh}
        found.append((mesh, own.get(False), own.get(True)))
    return found


def feasible(pair):
    """Those with a map either way."""
    return [(a, b) for _, a, b in pair if a and b and a.ok and b.ok]


def total(both, name):
    return [f"{sum(run.value(name) or 0 for run in runs):.0f}" for runs in zip(*both)] if both else ["-", "-"]


def outcomes(runs):
    found = [run.outcome for run in runs if run]
    return ", ".join(f"{found.count(outcome)} {outcome}" for outcome in sorted(set(found), key=found.count, reverse=True))


def summary(runs):
    found = pairs(runs)
    both = feasible(found)
    active = [(run.value("active_edges_before"), run.value("active_edges_after")) for _, _, run in found
              if run and run.value("active_edges_before")]
    ratios = [[measure(b) / measure(a) for a, b in both if measure(a) and measure(b)] for measure in
              (lambda run: run.value("quasi_conformal_mean") - 1, lambda run: run.value("quasi_conformal_max"),
               lambda run: run.map_cpu or run.cpu)]
    rows = [["outcomes", outcomes(a for _, a, _ in found), outcomes(b for _, _, b in found)],
            ["active edges, of meshes that have some", f"{sum(a for a, _ in active):.0f}", f"{sum(b for _, b in active):.0f}"],
            ["rounds of the loop of locked edges", *total(both, "delaunay_rounds")],
            ["triangles flipped in the chart", *total(both, "flipped_in_chart")],
            ["vertices moved", *total(both, "moved_vertices")],
            *([name, "1", quantiles(values)] for name, values in
              zip(("qc mean less 1", "qc max", "CPU time of the map"), ratios))]
    return "\n\n".join([f"Totals and ratios, median (least to greatest), are of the {len(both)} meshes that have a map either way.",
                        table(["", "locked edges alone", "after flips of active edges"], rows, 3)])


def by_mesh(runs):
    rows = []
    for mesh, plain, flips in pairs(runs):
        if not any(run and run.outcome not in ("invalid_input", "failed") for run in (plain, flips)):
            continue
        rows.append([mesh, (plain or flips).triangles] +
                    [number(flips and flips.value(name), "{:.0f}") for name in
                     ("active_edges_before", "active_edges_after", "retriangulation_flips", "retriangulation_rounds")] +
                    [shown(run, run and run.value(name), form) for name, form in
                     (("delaunay_rounds", "{:.0f}"), ("quasi_conformal_mean", "{:.5f}"), ("quasi_conformal_max", "{:.4g}"))
                     for run in (plain, flips)] +
                    [number(run and run.cpu, "{:.2f}") for run in (plain, flips)])
    head = ["mesh", "triangles", "active before", "after", "flips", "rounds"]
    head += [f"{name}{which}" for name in ("loop's rounds", "qc mean", "qc max", "CPU [s]") for which in ("", ", flips")]
    return table(head, rows)


def tables(runs):
    return "\n\n".join(["# Flips of active edges", summary(runs), "## Mesh by mesh", by_mesh(runs)])


def draw(runs, path):
    drawing, axis = plt.subplots(figsize=(5, 4))
    both = feasible(pairs(runs))
    axis.plot([a.value("quasi_conformal_mean") - 1 for a, _ in both], [b.value("quasi_conformal_mean") - 1 for _, b in both],
              "o", markersize=3, color=records.COLOURS[0])
    axis.set(xlabel="quasi_conformal_mean - 1, locked edges alone", ylabel="after flips of active edges", xscale="log", yscale="log")
    records.save(drawing, path)

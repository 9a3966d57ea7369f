"""Time by stage and memory against size, also as multiples of the reference factorization R of the same mesh."""
from tables import records
from tables.records import number, plt, power_fit, table

OUTPUT = "scaling"
STAGES = ["read", "preflight", "triangulation", "angles", "radii", "layout", "measures"]
MIB = 2.0 ** 20


def families(runs):
    """{family: its runs with a map, the smallest first}."""
    found = {}
    for run in sorted(runs, key=lambda run: (run.family, run.triangles)):
        if run.ok:
            found.setdefault(run.family, []).append(run)
    return found


def solve_seconds(run):
    """Wall time without reading and making the mesh."""
    return sum(run.seconds(stage) or 0 for stage in STAGES if stage not in ("read", "preflight"))


def wall_reference(run):
    return run.record.get("reference", {}).get("seconds")


def multiple(seconds, reference):
    return None if not seconds or not reference else seconds / reference


def stage_rows(own):
    return [[run.mesh, run.triangles] + [number(run.seconds(stage)) for stage in STAGES] +
            [number(run.seconds("total")), number(run.map_cpu), number(run.memory, "{:.0f}"),
             number(run.memory and run.memory * MIB / run.triangles, "{:.0f}")] for run in own]


def multiple_rows(own):
    stages = STAGES[2:]
    return [[run.mesh, run.triangles, number(wall_reference(run))] +
            [number(multiple(run.seconds(stage), wall_reference(run)), "{:.1f}") for stage in stages] +
            [number(multiple(solve_seconds(run), wall_reference(run)), "{:.1f}"),
             number(multiple(run.map_cpu, run.reference), "{:.1f}")] for run in own]


def exponent(own, measure):
    fit = power_fit([run.triangles for run in own], [measure(run) for run in own])
    return "-" if fit is None else f"{fit[0]:.2f}"


def exponent_rows(found):
    rows = []
    for family, own in found.items():
        measures = [lambda run, stage=stage: run.seconds(stage) for stage in STAGES]
        measures += [lambda run: run.seconds("total"), lambda run: run.map_cpu, wall_reference, lambda run: run.memory]
        sizes = f"{own[0].triangles} to {own[-1].triangles}"
        rows.append([family, sizes] + [exponent(own, measure) for measure in measures])
    return rows


def failures(runs):
    failed = [run for run in runs if not run.ok]
    if not failed:
        return "Every run ended in a map."
    return "Without a map: " + ", ".join(f"{run.mesh} ({run.outcome})" for run in failed) + "."


def machine(runs):
    provenance = runs[0].record.get("provenance", {})
    return (f"{provenance.get('cpu', 'unknown CPU')}, one BLAS thread; commit {provenance.get('commit', 'unknown')}. "
            "Stage times and their multiples are wall time. CPU is CPU time without reading or generating the mesh; it does "
            "not depend on what else the machine does.")


def tables(runs):
    found = families(runs)
    if not found:
        raise records.BadRecords("no run ended in a map: there is nothing to tabulate")
    every = [run for own in found.values() for run in own]
    return "\n\n".join([
        "# Time and memory against size", machine(runs), failures(runs),
        "## Growth: the exponent p of c triangles^p, by least squares of the logarithms",
        table(["family", "triangles"] + STAGES + ["total", "CPU", "R", "memory"], exponent_rows(found), 2),
        "## Times by stage [s], peak memory [MiB], bytes a triangle",
        table(["mesh", "triangles"] + STAGES + ["total", "CPU", "MiB", "bytes"], stage_rows(every)),
        "## As multiples of R, one factorization of the V x V cotangent Laplacian",
        table(["mesh", "triangles", "R [s]"] + STAGES[2:] + ["all of these", "CPU / R"], multiple_rows(every))])


def draw(runs, path):
    figure, (time, memory) = plt.subplots(1, 2, figsize=(8, 3.6))
    for colour, marker, (family, own) in zip(records.COLOURS * 3, "os^Dv<>p" * 3, families(runs).items()):
        sizes = [run.triangles for run in own]
        time.plot(sizes, [run.seconds("total") for run in own], marker + "-", color=colour, markersize=3, label=family)
        reference = [(run.triangles, wall_reference(run)) for run in own if wall_reference(run)]
        if reference:
            time.plot(*zip(*reference), marker + ":", color=colour, markersize=2)
        memory.plot(sizes, [run.memory for run in own], marker + "-", color=colour, markersize=3, label=family)
    time.plot([], [], ":", color="#888888", label="R")
    time.set(xscale="log", yscale="log", xlabel="triangles", ylabel="time [s]")
    memory.set(xscale="log", yscale="log", xlabel="triangles", ylabel="peak memory [MiB]")
    time.legend(fontsize=6)
    records.save(figure, path)

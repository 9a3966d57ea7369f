"""Iterations, factorizations and time of every strategy against the size of the mesh."""
from tables import records
from tables.records import plt, power_fit, shown, table

OUTPUT = "strategies_by_size"
PROBLEMS = {
    "log radii": ("radii", lambda run: run.group.startswith("radii"), lambda run: run.method["radii_solver"]),
    "angles, quadratic": ("angle", lambda run: run.group.startswith("angles") and
                          run.method["angle_objective"] == "quadratic", lambda run: run.method["angle_solver"]),
    "angles, barrier": ("angle", lambda run: run.group.startswith("angles") and run.method["angle_objective"] == "barrier",
                        lambda run: run.method["angle_solver"]),
}


def problem_runs(runs, problem):
    """{(mesh, strategy): run} and the strategies in order."""
    _, belongs, strategy = PROBLEMS[problem]
    own = [run for run in runs if belongs(run)]
    return {(run.mesh, strategy(run)): run for run in own}, records.in_order(strategy(run) for run in own)


def cell(run, stage):
    """"iterations / factorizations / CPU seconds of the run"."""
    if run is None:
        return ""
    if not run.ok:
        return run.outcome
    if is_retried(run):
        return "not_converged, retried"
    factorizations = run.value(f"{stage}_factorizations")
    return (f"{run.value(f'{stage}_iterations'):.0f} / {shown(run, factorizations, '{:.0f}')} / "
            f"{shown(run, run.cpu)}")


def is_retried(run):
    """Whether another method fitted the angles in the end."""
    return run.value("angle_fit_retried") == 1


def growth(found, strategy, meshes):
    """The exponent of the CPU time over triangles on the generated family."""
    own = [found[mesh, strategy] for mesh in meshes
           if (mesh, strategy) in found and found[mesh, strategy].ok and
           found[mesh, strategy].family == "bumpy_terrain"]
    fit = power_fit([run.triangles for run in own], [run.cpu for run in own])
    return "-" if fit is None else f"{fit[0]:.2f}"


def problem_table(runs, problem):
    stage = PROBLEMS[problem][0]
    found, strategies = problem_runs(runs, problem)
    meshes = [mesh for mesh in records.by_size(runs) if any((mesh, strategy) in found for strategy in strategies)]
    size = {mesh: run.triangles for (mesh, _), run in found.items()}
    rows = [[mesh, size[mesh]] + [cell(found.get((mesh, strategy)), stage) for strategy in strategies]
            for mesh in meshes]
    rows.append(["exponent of the time", ""] + [growth(found, strategy, meshes) for strategy in strategies])
    return table(["mesh", "triangles"] + [f"`{strategy}`" for strategy in strategies], rows)


def tables(runs):
    text = ["# Strategies against size",
            "Cells: iterations / factorizations of the stage / CPU time of the whole run [s], in which the other stages are "
            "the same; or the outcome of a run without a map. \"Retried\": the interior point had to finish the fit. A number "
            "of iterations at the limit (2000) means that the gradient test was not met, yet the angle sums were to 1e-9 rad. "
            "The last row: the exponent p of CPU time = c triangles^p on `bumpy_terrain`, by least squares of the logarithms."]
    for problem in PROBLEMS:
        text += [f"## {problem.capitalize()}", problem_table(runs, problem)]
    return "\n\n".join(text)


def draw(runs, path):
    figure, axes = plt.subplots(1, len(PROBLEMS), figsize=(3.3 * len(PROBLEMS), 3), squeeze=False)
    for axis, (problem, (stage, _, _)) in zip(axes.flat, PROBLEMS.items()):
        found, strategies = problem_runs(runs, problem)
        for colour, marker, strategy in zip(records.COLOURS, "os^Dv<", strategies):
            points = sorted((run.triangles, run.value(f"{stage}_iterations")) for (_, name), run in found.items()
                            if name == strategy and run.ok and not is_retried(run))
            if points:
                axis.plot(*zip(*points), marker + "-", color=colour, markersize=3, linewidth=0.8, label=strategy)
        axis.set(xscale="log", yscale="log", title=problem, xlabel="triangles", ylabel="iterations")
        axis.legend(fontsize=6)
    records.save(figure, path)

# SPDX-License-Identifier: Apache-2.0
"""What radiosity costs: against the number of elements, by the order of its basis, and in a furnished
hall. Errors are the root of the sum of squares of irradiance at points over that of the reference,
which `path` has made; CPU seconds are those of whole processes."""
import json
import math
import os
import resource
import subprocess
import time

import scale_scenes

MOST_SLOPE = 1.1        # Of logarithms: time and links over elements.
HALL_SECONDS = 60       # CPU seconds, bytes and error of the hall.
HALL_BYTES = 2e9
HALL_ERROR = .02
EPSILONS = (6.4e-4, 1.6e-4, 4e-5, 1e-5, 2.5e-6, 6e-7)


def with_options(scene, folder, options):
    """The scene with more `Option "radiosity"` before its world."""
    copy = folder / f"radiosity_{scene.stem}.rib"
    text = scene.read_text(encoding="ascii")
    copy.write_text(text.replace("WorldBegin", f'Option "radiosity" {options}\nWorldBegin', 1),
                    encoding="ascii")
    return copy


class Stopped(SystemExit):
    """candela has taken more than it may."""


def limits(cpu_seconds):
    resource.setrlimit(resource.RLIMIT_CPU, (cpu_seconds, cpu_seconds + 2))
    resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))


def measured(bench, *words, cpu_seconds=600, statuses=(0,)):
    """CPU seconds, peak bytes and standard output of candela."""
    with subprocess.Popen([str(bench.bin / "candela"), *map(str, words)], env=bench.environment,
                          cwd=bench.scratch, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          text=True, preexec_fn=lambda: limits(cpu_seconds)) as process:
        output = process.stdout.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    seconds = usage.ru_utime + usage.ru_stime
    if process.returncode not in statuses:
        raise Stopped(f"bench/run: candela {' '.join(map(str, words))}: "
                      f"status {process.returncode} after {seconds:.0f} CPU s")
    return seconds, usage.ru_maxrss * 1024, output


def solved(bench, scene, options, **limit):
    """CPU seconds, peak bytes and statistics of a solution and hardly a picture."""
    figures = bench.scratch / "radiosity.json"
    seconds, peak, _ = measured(bench, with_options(scene, bench.scratch, options), "--quiet",
                                "--integrator", "radiosity", "--spp", 1, "--threads",
                                bench.arguments.threads, "--output-dir", bench.scratch, "--stats",
                                figures, **limit)
    return seconds, peak, json.loads(figures.read_text())


def irradiance(bench, scene, points, *options):
    """CPU seconds, and what each point is answered; those within something are told of, and 0."""
    seconds, _, output = measured(bench, "probe", scene, points, "--quiet", *options,
                                  statuses=(0, 1))
    return seconds, [float(line.split()[3]) for line in output.splitlines()]


def error(found, reference):
    return math.sqrt(sum((a - b) ** 2 for a, b in zip(found, reference)) /
                     sum(b * b for b in reference))


def slope(pairs):
    """Of the line through the logarithms of (x, y)."""
    xs, ys = ([math.log(value) for value in values] for values in zip(*pairs))
    x, y = sum(xs) / len(xs), sum(ys) / len(ys)
    return sum((a - x) * (b - y) for a, b in zip(xs, ys)) / sum((a - x) ** 2 for a in xs)


def growth(bench, scene):
    """Time, links and memory over elements."""
    runs = []
    for epsilon in EPSILONS:
        seconds, peak, figures = solved(bench, scene, f'"float epsilon" {epsilon:g}')
        runs.append({"epsilon": epsilon, "seconds": seconds, "peakBytes": peak,
                     "elements": figures["radiosity.elements"],
                     "links": figures["radiosity.links"] + figures["radiosity.lampLinks"]})
    base = solved(bench, scene, '"float epsilon" 1')[0]
    elements = [run["elements"] for run in runs]
    bench.row("radiosity: elements of scene A, coarsest to finest",
              f"{min(elements)} to {max(elements)}")
    for what, limit in (("links", MOST_SLOPE), ("seconds", MOST_SLOPE)):
        pairs = [(run["elements"], run[what] - (base if what == "seconds" else 0)) for run in runs
                 if what == "links" or run["seconds"] > 1.2 * base]
        value = slope(pairs)
        bench.row(f"radiosity: {what} over elements, slope of logarithms", f"{value:.2f}",
                  f"<= {limit}", value <= limit)
    first, last = runs[0], runs[-1]
    share = (last["peakBytes"] - first["peakBytes"]) / (last["elements"] - first["elements"])
    bench.row("radiosity: peak bytes an element, its links included", f"{share:.0f}")
    return runs


def orders(bench, scene):
    """M1 against M2: CPU seconds at the error that both reach."""
    points = bench.scratch / "radiosity_points.txt"
    points.write_text("".join(f"{.2 + .5 * i:g} .001 {.2 + .5 * k:g} 0 1 0\n"
                              for i in range(11) for k in range(11)), encoding="ascii")
    reference = irradiance(bench, scene, points, "--integrator", "path", "--spp", 16384)[1]
    open_points = [k for k, value in enumerate(reference) if value > 0]
    runs = {}
    for order in (1, 2):
        runs[order] = []
        for epsilon in EPSILONS[1:5]:
            copy = with_options(scene, bench.scratch,
                                f'"integer order" {order} "float epsilon" {epsilon:g}')
            seconds, found = irradiance(bench, copy, points, "--integrator", "radiosity")
            runs[order].append({"epsilon": epsilon, "seconds": seconds,
                                "error": error([found[k] for k in open_points],
                                               [reference[k] for k in open_points])})
    reached = max(min(run["error"] for run in runs[order]) for order in runs)
    times = {order: min(run["seconds"] for run in runs[order] if run["error"] <= reached)
             for order in runs}
    bench.row(f"radiosity: CPU s of M1 and M2 at {100 * reached:.2g} % of error",
              f"{times[1]:.3g}, {times[2]:.3g}")
    return runs


def hall(bench):
    """200,000 triangles of furniture under lamps."""
    scene, points = bench.scratch / "furnished.rib", bench.scratch / "furnished.txt"
    free = scale_scenes.furnished_hall(scene)
    points.write_text("".join(f"{x:g} 0 {z:g} 0 1 0\n" for x, z in free), encoding="ascii")
    try:
        seconds, peak, figures = solved(bench, scene, '"string finalpass" "fe"',
                                        cpu_seconds=2 * HALL_SECONDS)
    except Stopped as stopped:
        bench.row("furnished hall: stopped", f"{2 * HALL_SECONDS} CPU s", f"<= {HALL_SECONDS}",
                  False)
        return {"stopped": str(stopped)}
    copy = with_options(scene, bench.scratch, '"string finalpass" "fe"')
    found = irradiance(bench, copy, points, "--integrator", "radiosity")[1]
    reference = irradiance(bench, scene, points, "--integrator", "path", "--spp", 16384)[1]
    missed = error(found, reference)
    bench.row("furnished hall: triangles, elements",
              f"{figures['scene.triangles']:.0f}, {figures['radiosity.elements']:.0f}")
    bench.row("furnished hall: CPU s", f"{seconds:.3g}", f"<= {HALL_SECONDS}",
              seconds <= HALL_SECONDS)
    bench.row("furnished hall: peak GB", f"{peak / 1e9:.2f}", f"<= {HALL_BYTES / 1e9:g}",
              peak <= HALL_BYTES)
    bench.row("furnished hall: error of irradiance on the floor", f"{100 * missed:.2g} %",
              f"<= {100 * HALL_ERROR:g} %", missed <= HALL_ERROR)
    return {"seconds": seconds, "peakBytes": peak, "error": missed,
            "elements": figures["radiosity.elements"], "links": figures["radiosity.links"]}


def radiosity(bench):
    scene = bench.here / "scenes" / "cornell_grey.rib"
    bench.results["radiosity"] = {"load": os.getloadavg()[0], "begin": time.strftime("%H:%M"),
                                  "growth": growth(bench, scene), "orders": orders(bench, scene),
                                  "hall": hall(bench)}

#!/usr/bin/env python3
"""What `hottel plan` says a scene will cost, against the processor seconds that `hottel solve` then takes.

    benchmarks/plan_estimates.py [--cases DIR] [--taken FILE] [--only WORD] [--at-most S] > table.md

Runs both on one thread: the scenes that come with hottel, those of a folder (--cases), and scenes that are generated,
half of which nothing was fitted to (held out). Times below 0.05 s count as 0.05 s. --taken keeps what solve took from one
run to the next. Solves of more than S seconds (100) are left out, and said so.
"""
import argparse, json, os, pathlib, resource, subprocess, sys, tempfile, time

ROOT = pathlib.Path(__file__).resolve().parent.parent
LEAST = 0.05
SHIPPED = sorted(
    str(path.relative_to(ROOT)) for folder in ("showcase", "heat", "lights", "space") for path in (ROOT / "scenes" / folder).glob("*.json")
) + ["scenes/space/two_boxes.json --elements 4", "scenes/space/room_windows.obj", "scenes/space/partition.vs3", "scenes/space/crate.vs3"]

# kind: n that constants may be fitted to, by seed 1; n that is held out, by seed 2.
GENERATED = {
    "room": (100, 400), "clutter": (200, 1000), "lattice": (100, 300), "maze": (300, 1000), "comb": (200, 400),
    "star": (100, 300), "pillars": (200, 500), "plates": (60, 200),
    "room-boxes": (8, 16), "room-stacked": (8, 16), "room-touching": (8, 14), "room-floating": (8, 16),
    "room-turned": (6, 12), "room-piercing": (6, 10), "street-blocks": (10, 20), "town": (2, 4), "terrain": (200, 300),
    "nested-cubes": (6, 12), "triangle-soup": (20, 40), "furnished-room": (348, 348), "flat": (350, 350),
    "lattice-boxes": (8, 16),
}


def seconds_of(command, at_most):
    """Processor seconds of a command, or None where it failed or took too long; and what it wrote."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, cwd=ROOT)
    try:
        out, _ = process.communicate(timeout=at_most)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        return None, f"more than {time.monotonic() - start:.0f} s"
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if process.returncode != 0:
        return None, f"exit code {process.returncode}"
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, out


def scenes(hottel, cases, folder):
    """(set, name, arguments) of each scene."""
    for scene in SHIPPED:
        yield "shipped", scene.removeprefix("scenes/"), scene.split()
    for file in sorted(pathlib.Path(cases).iterdir()) if cases else ():
        if file.suffix in (".json", ".obj", ".stl", ".vs3", ".wkt", ".geojson", ".svg"):
            yield "cases", file.name, [str(file)]
    for kind, sizes in GENERATED.items():
        for seed, n in enumerate(sizes, 1):
            file = f"{folder}/{kind}-{n}-{seed}.json"
            subprocess.run([hottel, "generate", kind, "--n", str(n), "--seed", str(seed), "-o", file, "--quiet"], check=True)
            yield ("fitted" if seed == 1 else "held out"), f"{kind} --n {n} --seed {seed}", [file]


def measured(hottel, arguments, known, at_most):
    plan_seconds, out = seconds_of([hottel, "plan", *arguments, "--json", "--threads", "1"], at_most)
    if plan_seconds is None:
        return None
    effects = {e["effect"]: e["seconds_estimate"] for e in json.loads(out)["plan"] if e["seconds_estimate"] > 0}
    row = {"plan_took": plan_seconds, "effects": effects, "said": sum(effects.values())}
    if known:
        return row | {key: known[key] for key in ("took", "stages", "why") if key in known}
    with tempfile.TemporaryDirectory() as results:
        took, out = seconds_of([hottel, "solve", *arguments, "-o", results, "--json", "--quiet", "--threads", "1"], at_most)
    if took is None:
        return row | {"took": None, "why": out}
    return row | {"took": took, "stages": json.loads(out)["seconds"]}


def ratio(row):
    return max(row["said"], LEAST) / max(row["took"], LEAST)


def within(rows, factor):
    return sum(1 / factor <= ratio(row) <= factor for row in rows)


def table(rows):
    for name in dict.fromkeys(row["set"] for row in rows):
        mine = [row for row in rows if row["set"] == name]
        done = [row for row in mine if row["took"] is not None]
        print(f"\n### {name.capitalize()}\n\n{len(done)} scenes; within a factor of 3: {within(done, 3)}, of 2: {within(done, 2)}.\n")
        print("| scene | plan says | solve takes | ratio | plan takes |\n|---|--:|--:|--:|--:|")
        for row in mine:
            took = f"{row['took']:.3g}" if row["took"] is not None else row["why"]
            told = f"{ratio(row):.2f}" if row["took"] is not None else ""
            print(f"| {row['scene']} | {row['said']:.3g} | {took} | {told} | {row['plan_took']:.2g} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cases", help="a folder of scenes beside")
    parser.add_argument("--taken", help="keep what solve took in this file, and take it from there")
    parser.add_argument("--only", default="", help="scenes whose name or set has this word")
    parser.add_argument("--at-most", type=float, default=100, help="seconds of a solve")
    parser.add_argument("--hottel", default=str(ROOT / "build/release/hottel"))
    asked = parser.parse_args()
    kept = json.loads(pathlib.Path(asked.taken).read_text()) if asked.taken and os.path.exists(asked.taken) else {}
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for group, name, arguments in scenes(asked.hottel, asked.cases, folder):
            if asked.only not in name and asked.only not in group:
                continue
            row = measured(asked.hottel, arguments, kept.get(name), asked.at_most)
            if row is None:
                continue
            rows.append({"set": group, "scene": name} | row)
            kept[name] = rows[-1]
            print(json.dumps(rows[-1]), file=sys.stderr)
            if asked.taken:
                pathlib.Path(asked.taken).write_text(json.dumps(kept, indent=1))
    table(rows)


main()

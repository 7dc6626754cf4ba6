#!/usr/bin/env python3
"""Writes results/reference/performance.md: every stage of this tree beside an earlier commit, on one core.

usage: scripts/performance.py [BASE] [--base-tree DIR] [--rounds N] [--core C] [--no-instructions]

BASE is a commit (default: e2fde3a), built in a worktree (default: build/performance_base) that is made where it is
missing. The benchmarks of both take turns, pinned to one core, on an otherwise idle machine. Instructions are counted
by callgrind. What stands in the document below "## Steps" is written by hand and kept.
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
DOCUMENT = ROOT / "results/reference/performance.md"
MODES = ("default", "paper")
TARGETS_MS = {"default": 5, "paper": 4}


def run(*command, **options):
    return subprocess.run([str(c) for c in command], check=True, text=True, **options)


def build(source, *options):
    """The benchmarks of a tree, as released."""
    binary_dir = source / "build/release"
    quiet = {"stdout": subprocess.DEVNULL, "cwd": source}
    run("cmake", "--preset", "release", "-DFACET_CUDA=OFF", *options, **quiet)
    run("cmake", "--build", binary_dir, "--target", "bench_stages", "count_stages", **quiet)
    return binary_dir


def build_base(commit, tree):
    """An earlier commit with the benchmarks of this tree."""
    if not tree.exists():
        run("git", "worktree", "add", "--detach", tree, commit, cwd=ROOT)
    run("git", "checkout", "--quiet", "--force", "--detach", commit, cwd=tree)  # of files of ours from the last time
    for name in ("bench_scene.cpp", "bench_scene.hpp", "bench_stages.cpp", "CMakeLists.txt", "count_stages.cpp",
                 "stage_traffic.cpp", "stage_traffic.hpp"):
        shutil.copy(ROOT / "tools" / name, tree / "tools" / name)
    shutil.copy(ROOT / "cmake/FacetBuild.cmake", tree / "cmake/FacetBuild.cmake")  # what those files call
    return build(tree, "-DFACET_TESTS=OFF")


def bench(binaries, pattern, cores):
    """name -> row of what a run of bench_stages says, and its peak memory [MiB]."""
    process = subprocess.Popen(["taskset", "-c", cores, str(binaries / "bench_stages"), "--benchmark_format=json",
                                f"--benchmark_filter=^({pattern})"],
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    text = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        raise SystemExit(f"bench_stages failed: {status}")
    rows = {}
    for row in json.loads(text)["benchmarks"]:
        name = "/".join(part for part in row["name"].split("/") if ":" not in part and part != "manual_time")
        rows[name] = row
    return rows, usage.ru_maxrss / 1024


class Times:
    """What the rounds of one tree say."""

    def __init__(self):
        self.rounds = []

    def of(self, name, key="real_time"):
        return statistics.median(rows[name][key] for rows in self.rounds)

    def least(self, name):
        return min(rows[name]["min_ms"] for rows in self.rounds)

    def names(self):
        return list(self.rounds[0])


def count_instructions(binaries, mode):
    """stage -> millions of instructions per frame."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out"
        printed = run("valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", binaries / "count_stages", mode, 640,
                      480, 1, capture_output=True).stdout
        annotated = run("callgrind_annotate", "--inclusive=yes", "--threshold=100", out, capture_output=True).stdout
    stages = dict(re.findall(r"^counted_(\d+) (\w+)$", printed, re.M))
    counts = {}
    for count, stage in re.findall(r"^\s*([\d,]+) .*counted<(\d+)>", annotated, re.M):
        counts[stages[stage]] = max(counts.get(stages[stage], 0), int(count.replace(",", "")) / 1e6)
    return counts


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "| --- |" + " ---: |" * (len(header) - 1)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def mode_section(mode, base, new, instructions, copy_bytes_per_s):
    rows = []
    names = [name for name in new.names() if name.startswith(f"{mode}/") and name.endswith("/640x480")]
    for name in names:
        stage = name.split("/")[1]
        row = new.rounds[0][name]
        before, after = base.of(name), new.of(name)
        moved = row.get("bytes_per_second", 0) * row["real_time"] / 1000
        floor = f"{1000 * moved / copy_bytes_per_s:.2f}" if moved else "n/a"
        counts = ["n/a", "n/a"]
        if instructions:
            counts = [f"{sum(tree[mode].values()) if stage == 'total' else tree[mode].get(stage, 0):.1f}"
                      for tree in instructions]
        rows.append([stage, f"{before / base.of('calibration'):.3f}", f"{after / new.of('calibration'):.3f}",
                     f"{after / before:.2f}", f"{new.least(name) / base.least(name):.2f}", f"{after:.2f}", floor, *counts])
    header = ["stage", "before", "after", "ratio", "ratio of least", "after \\[ms\\]", "floor \\[ms\\]", "before \\[M instr.\\]",
              "after \\[M instr.\\]"]
    return f"**{mode}**\n\n" + table(header, rows)


def figures(new, binaries, cores):
    two, _ = bench(binaries, "(default|paper)/two_threads/640x480", "0,1")
    large, _ = bench(binaries, "(default|paper)/total/1280x720", cores)
    _, libraries_mib = bench(binaries, "calibration", cores)
    rows = []
    for mode in MODES:
        total = f"{mode}/total/640x480"
        _, peak_mib = bench(binaries, total, cores)
        median = new.of(total)
        rows.append([mode, f"{median:.1f} (<= {TARGETS_MS[mode]})", f"{new.of(total, 'p90_ms') / median:.2f} (<= 1.3)",
                     f"{two[f'{mode}/two_threads/640x480']['real_time'] / median:.2f} (<= 0.6)",
                     f"{large[f'{mode}/total/1280x720']['real_time'] / median:.2f} (<= 3.2)",
                     f"{peak_mib - libraries_mib:.0f} (<= 60)"])
    return table(["mode", "frame, median \\[ms\\]", "p90 / median", "two threads / one", "1280x720 / 640x480",
                  "peak memory beyond the libraries \\[MiB\\]"], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("base", nargs="?", default="e2fde3a")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--core", default="0")
    parser.add_argument("--no-instructions", action="store_true")
    parser.add_argument("--base-tree", type=pathlib.Path, default=ROOT / "build/performance_base")
    options = parser.parse_args()
    trees = [build_base(options.base, options.base_tree), build(ROOT)]
    times = [Times(), Times()]
    load = os.getloadavg()[0]
    pattern = "calibration|copy/640x480|(default|paper)/[a-su-z].*/640x480|(default|paper)/t(emporal|otal)/640x480"
    for _ in range(options.rounds):
        for binaries, taken in zip(trees, times):
            taken.rounds.append(bench(binaries, pattern, options.core)[0])
    base, new = times
    instructions = None
    if not options.no_instructions:
        instructions = [{mode: count_instructions(binaries, mode) for mode in MODES} for binaries in trees]
    copy = new.of("copy/640x480", "bytes_per_second")
    commits = [run("git", "rev-parse", "--short=8", ref, cwd=ROOT, capture_output=True).stdout.strip()
               for ref in (options.base, "HEAD")]
    cpu = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text()).group(1)
    text = f"""# Time of a frame on a CPU, stage by stage

`scripts/performance.py` writes this page again: {commits[0]} (before) and {commits[1]} (after) in {options.rounds} rounds in turn, each the
median of 64 frames of 640x480, one core of an {cpu}. Before and after are
multiples of the calibration block of the same run ({base.of('calibration'):.2f} and {new.of('calibration'):.2f} ms; fixed OpenCV operations). Ratio is after by
before in time, of the medians and of the least times, which other work on the machine moves less. Floor: the bytes of the images
that the stage reads and writes, each counted once per pass, over the {copy / 1e9:.1f} GB/s at which an image of that size is copied here (read and write together). Instructions:
callgrind, one frame, which sees AVX2 at most. Load of the machine when the rounds began: {load:.1f} (0 = idle).

{mode_section('default', base, new, instructions, copy)}
{mode_section('paper', base, new, instructions, copy)}
**Against the targets**

{figures(new, trees[1], options.core)}
"""
    kept = DOCUMENT.read_text() if DOCUMENT.exists() else ""
    DOCUMENT.write_text(text + kept[kept.index("## Steps"):] if "## Steps" in kept else text)
    print(DOCUMENT)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Adds made-up areas and speeds to a report that was made without them, so that a test can look at the charts that show
areas without running synthesis.

usage: made_up_areas.py REPORT.json      writes the report with areas to standard output
"""
import json
import sys

# NAND2 of each stage, and the stages that the paper takes as given.
STAGES = {"packet": 6000, "scan": 5400, "interpolate": 24000, "texture coordinates": 11000, "texture": 51200,
          "perturb": 0, "normalize": 19800, "light": 13300, "output": 7900}
GIVEN = ("scan", "texture", "texture coordinates")


def area(name, changes):
    """The areas of one figure or configuration; `changes` are added to its stages, by name."""
    stages = [{"stage": stage, "given": stage in GIVEN, "nand2": nand2 + changes.get(stage, 0), "um2": 24 * nand2,
               "flip_flops": nand2 // 20, "critical_path_ns": 8.5} for stage, nand2 in STAGES.items()]
    return {"name": name, "library": "made up", "um2": sum(s["um2"] for s in stages),
            "nand2": sum(s["nand2"] for s in stages), "flip_flops": 5000,
            "nand2_given": sum(s["nand2"] for s in stages if s["given"]), "critical_path_ns": 9.25,
            "deviation": 0.01, "checked": {"clocks": 1234, "different": 0}, "stages": stages}


report = json.load(open(sys.argv[1]))
report["figures"] = {"fig1": area("fig1", {}), "fig2": area("fig2", {"interpolate": 21000, "perturb": 9000}),
                     "fig3": area("fig3", {"perturb": 83}), "fig2_over_fig1": 0.216, "fig3_over_fig1": 0.0006}
for i, config in enumerate(report["configs"]):
    config["area"] = area(config["name"], {"light": 9000 * i})
names = [{key: run[key] for key in ("name", "config", "scene")} for run in report["runs"]]
report["speed"] = {
    "runs": [{**run, "engines": [{"engine": name, "pixels_per_cpu_s": speed * (i + 1), "faithful_to": "made up"}
                                 for name, speed in (("ideal", 1e5), ("exact", 1e6), ("golden", 1e8), ("rtl", 3e6))]}
             for i, run in enumerate(names)],
    "chips": [{**run, "clocks_per_pixel": 1.01, "period_ns": 9.25, "pixels_per_s": 1.07e8} for run in names]}
json.dump(report, sys.stdout)

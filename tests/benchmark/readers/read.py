#!/usr/bin/env python3
"""Reads the pack and says of each scene how far the contact goes at the 64 instants: read.py FOLDER."""
import json
import sys

with open(sys.argv[1] + "/scenes.json", encoding="utf-8") as file:
    scenes = json.load(file)
for s in scenes:
    # masses s["m"], springs s["k"], dashpots s["c"] and s["c_ground"], load s["P"] cos(s["omega"] t) on mass s["load"],
    # friction s["F"] and s["F_static"] on mass s["contact"]; counted from 1
    j = s["contact"] - 1
    x, v = s["x"][j], s["v"][j]  # at t = n * period / 64
    stops = sum(event["what"] == "stops" for event in s["events"])
    print(s["scene"], len(s["m"]), s["regime"], stops, "%.17g" % max(abs(a) for a in x), "%.17g" % max(abs(a) for a in v))

#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""render.py RESULTS OUT.md PICTURES: writes the comparison with the paper from what the experiments left in the folder
RESULTS, and copies their pictures into the folder PICTURES. Chapters of experiments that were not run are left out."""
import pathlib
import shutil
import sys

import back_end
import corridors
import front_end
import monte_carlo
import planners
import profiles
import theory
from markdown import Results, wrapped

CHAPTERS = [front_end, monte_carlo, corridors, back_end, profiles, planners, theory]

HEAD = """# The paper's experiments

Section 4 of Mai, Lin, Dong, Liu, *Efficient Trajectory Planning for Drone-Based Logistics: A JPS–Bresenham and
Ellipsoid-Based Safe Corridor Approach*, Drones 10 (2026) 323, repeated with Tern and with baselines written or set up for the purpose ([bench/baselines](../bench/baselines)). One
command runs the experiments and writes this page and its pictures:

```sh
tools/paper           # all of it; tools/paper --only PART repeats one experiment, --quick tries all of them
```

The paper's figures stand beside ours. Its times were measured in MATLAB on an Intel i5-12400. Ours were measured in
C++ on the machine that each chapter names, which was shared with other work. So compare the columns of one table, not
our milliseconds with the paper's seconds.

"""


def main():
    results, page, pictures = Results(sys.argv[1]), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    chapters = [c for c in CHAPTERS if (results.folder / c.PART / "done").exists()]
    for missing in [c.PART for c in CHAPTERS if c not in chapters]:
        print(f"render: no results of {missing}: its chapter is left out", file=sys.stderr)
    pictures.mkdir(parents=True, exist_ok=True)
    drawn = [picture for chapter in chapters for picture in results.pictures(chapter.PART)]
    for picture in drawn:
        shutil.copyfile(picture, pictures / picture.name)
    page.write_text(wrapped(HEAD + "\n".join(c.chapter(results) for c in chapters)))
    print(f"paper: {page} and {len(drawn)} pictures in {pictures}")


main()

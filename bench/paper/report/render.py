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
Ellipsoid-Based Safe Corridor Approach*, Drones 10 (2026) 323, done again with Tern and with baselines written or set up for
the purpose ([bench/baselines](../bench/baselines)). This page and its pictures are written by

```sh
tools/paper           # all of it; tools/paper --only PART repeats one experiment, --quick tries all of them
```

Every figure is of the run that it names. The paper's own are printed beside them. Its times are those of MATLAB on an Intel
i5-12400, ours of C++ on the machine named in each chapter, which was shared with other work: compare columns of one table,
not our milliseconds with its seconds.

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

#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""runner.py CAMPAIGN FOLDER: the campaign of proofs with a program in place of `tern`: a killed run goes on, and what is
not proven is kept and named."""
import pathlib
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from expectations import expect, status  # noqa: E402

PRETENDER = """#!/bin/sh
if [ "$1" = plan ]; then
  echo plan >>"{folder}/calls"
  case $(head -1 "$2") in
    "# boxes:2") echo '{{"status": "no_path"}}' >"$4"; exit 3 ;;
  esac
  cp "$2" "$4"
elif [ "$1" = fly ]; then
  for log; do [ "$log" = --commits ] || json=$log; done
  echo '{{"status": "reached", "plans": {{"committed": 70}}, "flown": true}}' >"$json"
elif grep -q flown "$2"; then
  echo "$*" >>"{folder}/flights"
  for proof; do :; done
  cat >"$proof" <<EOF
{{"files": [{{"verdict": "proven", "claims": [
 {{"claim": "flown: body off the world", "margin_at_least": "${{3#*:}}", "tolerance": "0"}},
 {{"claim": "takeover jerk", "margin_at_least": "-1e-9", "tolerance": "1e-4"}}]}}]}}
EOF
else
  verdict=proven; margin=0.5
  case $(head -1 "$2") in "# boxes:3") verdict=REFUTED; margin=-0.1 ;; esac
  cat >"$6" <<EOF
{{"files": [{{"verdict": "$verdict", "claims": [{{"claim": "curve off obstacles", "margin_at_least": "$margin",
 "tolerance": "1e-9"}}]}}]}}
EOF
  echo "$verdict curve"
  [ $verdict = proven ]
fi
"""


def main():
    campaign, folder = sys.argv[1], pathlib.Path(sys.argv[2], "pretended")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    program = folder / "tern"
    program.write_text(PRETENDER.format(folder=folder))
    program.chmod(0o755)

    def run(runs):
        return subprocess.run([sys.executable, campaign, "--family", "boxes", "--runs", str(runs), "--tern", str(program),
                               "--folder", str(folder), "--name", "n", "--jobs", "1"], capture_output=True, text=True)

    expect("proven plans alone end well", run(2).returncode == 0)
    refuted = run(4)
    expect("a refuted plan ends with 1", refuted.returncode == 1)
    expect("and is named", "not proven" in refuted.stdout and "boxes-3\n" in refuted.stdout)
    expect("and kept", (folder / "n/boxes-3/scenario.txt").read_text().startswith("# boxes:3\n"))
    expect("finished runs are not repeated", len((folder / "calls").read_text().split()) == 4)
    state = folder / "n.csv"
    state.write_text(state.read_text()[:-7])
    expect("a line that was cut off is run again, to the same table", run(4).stdout.splitlines()[-4:] ==
           refuted.stdout.splitlines()[-4:] and len((folder / "calls").read_text().split()) == 5)
    expect("the table has the least margin", "| boxes | 4 | 3 | 2 |" in refuted.stdout and "-0.1" in refuted.stdout)

    flown = subprocess.run([sys.executable, campaign, "--flights", "17", "--seed", "3", "--set", "tracking=quadrotor",
                            "--tern", str(program), "--folder", str(folder)], capture_output=True, text=True)
    expect("flights are proven", flown.returncode == 0 and "17 flights, 34 claims, 0 not proven" in flown.stdout)
    expect("against their worlds, with their settings", "P36:4 --set depth_noise=0.01 --set outliers=0.01 --set "
           "tracking=quadrotor --brief" in (folder / "flights").read_text())
    expect("into a table", "| P36 | 2 | 2 | 140 | 2 | -1e-09 (0.001 %) | 3 |" in flown.stdout)

    pairs = folder / "pairs"
    pairs.write_text(f'#!/bin/sh\necho "$*" >>{folder}/proven\n[ $1 = 6 ] && echo "case 7" && echo 800 300 1 && exit 1\n'
                     'echo 900 200 0\n')
    pairs.chmod(0o755)

    def prove_pairs(thousands):
        return subprocess.run([sys.executable, campaign, "--pairs", str(thousands), "--seed", "5", "--tern", str(pairs),
                               "--folder", str(folder), "--jobs", "1"], capture_output=True, text=True)

    expect("pairs are proven", prove_pairs(1).returncode == 0)
    unsound = prove_pairs(2)
    expect("one that is not so ends with 1", unsound.returncode == 1)
    expect("and is named", "case 7\nnot proven: seed 6" in unsound.stdout)
    expect("what was proven is kept", (folder / "proven").read_text() == "5 1000\n6 1000\n")
    expect("pairs are counted", "2 thousands of pairs, 1700 claims, 1 not proven" in unsound.stdout)
    return status()


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""runner.py CAMPAIGN FOLDER: the campaign of proofs with a program in place of `tern`: a killed run goes on, what is not
proven is kept and named, and the same table comes out."""
import pathlib
import shutil
import subprocess
import sys

PRETENDER = """#!/bin/sh
if [ "$1" = plan ]; then
  echo plan >>"{folder}/calls"
  case $(head -1 "$2") in
    "# boxes:2") echo '{{"status": "no_path"}}' >"$4"; exit 3 ;;
  esac
  cp "$2" "$4"
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

failures = 0


def expect(what, held):
    global failures
    failures += not held
    print(f"{'ok' if held else 'FAILED'}: {what}")


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
    expect("and is named", "not proven" in refuted.stdout and "boxes-3.txt" in refuted.stdout)
    expect("and kept", (folder / "n/boxes-3.txt").read_text().startswith("# boxes:3\n"))
    expect("finished runs are not repeated", len((folder / "calls").read_text().split()) == 4)
    state = folder / "n.csv"
    state.write_text(state.read_text()[:-7])
    expect("a line that was cut off is run again, to the same table", run(4).stdout.splitlines()[-4:] ==
           refuted.stdout.splitlines()[-4:] and len((folder / "calls").read_text().split()) == 5)
    expect("the table has the least margin", "| boxes | 4 | 3 | 2 |" in refuted.stdout and "-0.1" in refuted.stdout)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())

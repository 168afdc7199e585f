# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Keeps a failing run as a file that repeats it, and takes obstacles out of it while it still fails the same way."""
import pathlib
import tempfile

OBSTACLES = ("block", "cylinder", "appear", "run")  # records that may go


def ddmin(items, fails, trials):
    """A smaller list that still fails, by delta debugging (Zeller and Hildebrandt 2002): no part of the size reached
    last can go. `fails` is asked at most `trials` times. Returns the list and how often it was asked."""
    asked, parts = 0, 2
    while len(items) >= 1 and asked < trials:
        size = max(1, -(-len(items) // parts))
        smaller = None
        for begin in range(0, len(items), size):
            rest = items[:begin] + items[begin + size:]
            asked += 1
            if fails(rest):
                smaller = rest
                break
            if asked >= trials:
                break
        if smaller is not None:
            items, parts = smaller, max(2, parts - 1)
        elif size == 1:
            break
        else:
            parts = min(len(items), 2 * parts)
    return items, asked


def with_settings(lines, settings):
    """The file's records with those of --set in the place of their like."""
    given = dict(text.split("=", 1) for text in settings)
    kept = [line for line in lines if line.split()[:1] and line.split()[0] not in given]
    return kept + [f"{key} {value.replace(',', ' ')}" for key, value in given.items()]


def file_name(row, seed):
    return f"{row.replace('/', '-')}-{seed}.txt"


def is_obstacle(line):
    return line.split()[0] in OBSTACLES


def text_of(lines, kept):
    return "".join(f"{line}\n" for number, line in enumerate(lines) if not is_obstacle(line) or number in kept)


def keep(kind, entry, folder_name, trials):
    """Row and seed, the text of a file that fails as the run did (None where none does), and a word on it."""
    row, seed = entry["row"], int(entry["seed"])
    lines = with_settings([line for line in kind.world_file(entry).splitlines() if line.strip()],
                          kind.settings_of(row))
    wanted = kind.failure(entry)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "trial.txt")

        def fails(kept):
            path.write_text(text_of(lines, set(kept)))
            return kind.status_of(path, entry) == wanted

        obstacles = [number for number, line in enumerate(lines) if is_obstacle(line)]
        if not fails(obstacles):
            return row, seed, None, "the file of its world does not fail the same way"
        fewest, asked = ddmin(obstacles, fails, trials)
    command = " ".join(map(str, kind.file_command(f"{folder_name}/{file_name(row, seed)}", entry)))
    head = [f"# {kind.name} {row}, seed {seed}: {wanted}: {' '.join(str(entry.get('reason', '')).split())}",
            f"# {len(fewest)} of {len(obstacles)} obstacles are left after {asked} trials. Repeat it with",
            f"# {command}"]
    text = "".join(f"{line}\n" for line in head) + text_of(lines, set(fewest))
    return row, seed, text, f"{len(fewest)} of {len(obstacles)} obstacles still fail"

# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a campaign runs: plans, flights or attacks; faults.py and swarms.py have the other kinds. A kind says how runs
are grouped into jobs, does a job in processes of its own, says which runs failed and with which command one is
repeated."""
import csv
import io
import json
import math
import pathlib
import subprocess
import tempfile
import time

BLOCK = 500  # cases of one job of an attack: the attack keeps its state by such blocks
FIRST_TALLIES = ["cases", "plans", "replans", "compared", "hover", "stop_and_go", "optimised", "needed", "followed",
                 "work"]

TOUCHING = {"clearance", "boundary", "keep_in", "keep_out"}  # violations that are contacts


def settings_words(settings):
    return [word for text in settings for word in ("--set", text)]


def ended(done):
    """Why a process that should not have ended so did."""
    return f"exit {done.returncode}: {done.stderr.strip()[:200]}"


class Kind:
    settings_default = []  # of all runs, before those given
    keeps = True  # failing worlds as files
    broken = {"collision", "invariant", "crash", "too_long", "violation", "check_failed"}

    def __init__(self, program, settings, seed):
        self.program, self.settings, self.seed = program, settings, seed

    def failure(self, entry):
        """What a smaller world must answer, too."""
        return entry["status"]

    def excess(self, entry):
        """What voids a run's promise although nothing broke. Empty where nothing does."""
        return ""

    def failed(self, entry):
        """True for runs to report, and to keep the worlds of."""
        return entry["status"] != self.good

    def is_defect(self, entry):
        """True for what must never happen."""
        return entry["status"] in self.broken

    def rows(self, given):
        """The table's rows for those of the command line."""
        return given

    def settings_of(self, row):
        return self.settings

    def refusal(self, row):
        """What the program says where it knows no such family or setting; a short run tells. None where it does."""
        with tempfile.TemporaryDirectory() as folder:
            done = self.call(self.probe(row, folder), 120)
        return done.stderr.strip() if done is not None and done.returncode == 2 else None

    def call(self, words, seconds):
        try:
            return subprocess.run([self.program, *words], capture_output=True, text=True, timeout=seconds)
        except subprocess.TimeoutExpired:
            return None


class Fly(Kind):
    """Flight k of a row is the world FAMILY:k."""
    name, good, verb = "fly", "reached", "flights"
    # Noise of the sensor in all campaigns, unless --set says otherwise.
    settings_default = ["tracking=bounded", "tracking_margin=0.1", "depth_noise=0.01", "outliers=0.01"]
    fields = ["row", "seed", "status", "reason", "time_s", "length_m", "mean_speed", "min_clearance", "tracking_max",
              "full_knowledge_s", "straight_s", "standing_s", "asked", "committed", "dropped", "failed", "work_max",
              "work_total", "threat_s", "watched_points", "watched_voxels", "commands_hash", "broken_assumption",
              "contact_speed", "commanded_speed", "brake_speed", "touched_in_motion", "touched_at_rest", "left_out",
              "seconds"]

    def jobs(self, row, first, count):
        return [(row, seed, 1) for seed in range(first, first + count)]

    def command(self, row, seed):
        return [self.program, "fly", f"{row}:{seed}", "--compare", *settings_words(self.settings)]

    def probe(self, row, folder):
        return ["fly", f"{row}:{self.seed}", *settings_words(self.settings), "--set", "time_limit=0.1"]

    def is_defect(self, entry):
        """A contact is one unless the log names an assumption of the flight's promise that did not hold."""
        return super().is_defect(entry) and not (entry["status"] == "collision" and entry.get("broken_assumption"))

    def run(self, job):
        """One flight in a process of its own: a crash costs that flight alone."""
        row, seed, _ = job
        return [{"row": row, "seed": seed, **self.fly(self.command(row, seed)[1:])}]

    def fly(self, words):
        began = time.monotonic()
        with tempfile.TemporaryDirectory() as folder:
            log = pathlib.Path(folder, "log.json")
            done = self.call([*words, "--json", str(log)], 1200)
            if done is None:
                entry = {"status": "too_long", "reason": "the process was ended after 1200 s"}
            elif done.returncode in (0, 3):
                entry = self.read_log(log)
            else:
                entry = {"status": "crash", "reason": ended(done)}
        return {**entry, "seconds": round(time.monotonic() - began, 2)}

    @staticmethod
    def read_log(path):
        log = json.loads(path.read_text())
        contact = log.get("contact", {})
        return {"status": log["status"], "reason": log["reason"], "time_s": log["time_s"], "length_m": log["length_m"],
                "mean_speed": log["mean_speed"], "min_clearance": log["min_clearance"],
                "tracking_max": log["tracking_error"]["max"], "full_knowledge_s": log.get("full_knowledge_s", 0.0),
                "straight_s": log["straight_s"], "standing_s": log["standing_s"],
                **log["plans"], "work_max": log["work"]["max"], "work_total": log["work"]["total"],
                "threat_s": log["states"]["threat"], "watched_points": log["watched"]["points"],
                "watched_voxels": log["watched"]["voxels"], "commands_hash": log["commands_hash"],
                **{key: log["things"][key] for key in ("touched_in_motion", "touched_at_rest", "left_out")
                   if "things" in log},
                "broken_assumption": contact.get("broken_assumption"), "contact_speed": contact.get("speed"),
                **({key: contact[key] for key in ("commanded_speed", "brake_speed")} if contact.get("shown") else {})}

    def excess(self, entry):
        margin = dict(text.split("=", 1) for text in self.settings)["tracking_margin"]
        if float(entry.get("tracking_max") or 0.0) <= float(margin) * (1.0 + 1e-9):
            return ""
        return f"tracking error {float(entry['tracking_max']):.3f} m, margin {margin} m"

    def world_file(self, entry):
        return self.call(["world", f"{entry['row']}:{entry['seed']}"], 60).stdout

    def status_of(self, path, entry):
        return self.fly(["fly", str(path)])["status"]

    def file_command(self, path, entry):
        return [self.program, "fly", str(path)]


class Plan(Kind):
    """Plan k of a row goes through the world FAMILY:k with full knowledge. Jobs are batches; where one ends early, its
    plans are made one by one."""
    name, good, verb = "plan", "ok", "plans"
    fields = ["row", "seed", "status", "stage", "optimised", "duration_s", "length_m", "clearance", "least_clearance",
              "work", "hash", "reason", "seconds"]
    batch = 10

    def jobs(self, row, first, count):
        return [(row, seed, min(self.batch, first + count - seed)) for seed in range(first, first + count, self.batch)]

    def command(self, row, seed):
        return [self.program, "plan", f"{row}:{seed}", *settings_words(self.settings)]

    def probe(self, row, folder):
        return self.command(row, self.seed)[1:]

    def run(self, job):
        row, first, count = job
        seeds = range(first, first + count)
        began = time.monotonic()
        entries = self.plan([f"{row}:{seed}" for seed in seeds], self.settings, 60 + 20 * count)
        seconds = round((time.monotonic() - began) / count, 4)
        if isinstance(entries, str):
            alone = lambda seed: self.crashed(row, seed, entries) if count == 1 else self.run((row, seed, 1))[0]
            return [alone(seed) for seed in seeds]
        return [{"row": row, "seed": seed, **self.judged(entry), "seconds": seconds}
                for seed, entry in zip(seeds, entries)]

    @staticmethod
    def crashed(row, seed, reason):
        return {"row": row, "seed": seed, "status": "crash", "reason": reason}

    def plan(self, worlds, settings, seconds):
        """The rows of `tern table`, or why there are none."""
        with tempfile.TemporaryDirectory() as folder:
            rows = pathlib.Path(folder, "rows.csv")
            words = ["table", *worlds, "--repeat", "1", "--rows", str(rows), *settings_words(settings)]
            done = self.call(words, seconds)
            if done is None:
                return f"the process was ended after {seconds} s"
            return list(csv.DictReader(io.StringIO(rows.read_text()))) if done.returncode in (0, 3) else ended(done)

    @staticmethod
    def judged(entry):
        """A plan that comes nearer to a block than its clearance, less 2 nm, is a contact, whatever its status."""
        entry.pop("scenario")
        if entry["least_clearance"] and float(entry["least_clearance"]) < float(entry["clearance"]) - 2e-9:
            entry["status"] = "collision"
        return entry

    def world_file(self, entry):
        return self.call(["world", f"{entry['row']}:{entry['seed']}", "--scenario"], 60).stdout

    def status_of(self, path, entry):
        entries = self.plan([str(path)], [], 60)
        return "crash" if isinstance(entries, str) else self.judged(entries[0])["status"]

    def file_command(self, path, entry):
        return [self.program, "plan", str(path)]


class Attack(Kind):
    """Cases of one family of the attack (docs/attack.md), in blocks. A job's seed is the index of its first case."""
    name, good, verb = "attack", "ok", "blocks"
    fields = ["row", "seed", "status", "reason", *FIRST_TALLIES, "ok", "contacts", "violations", "seconds"]

    def jobs(self, row, first, count):
        return [(row, block * BLOCK, BLOCK) for block in range(math.ceil(count / BLOCK))]

    def command(self, row, seed):
        return [self.program, "--seed", str(self.seed), "--family", row, "--first", str(seed), "--cases", str(BLOCK)]

    def probe(self, row, folder):
        return ["--family", row, "--cases", "1", "--quiet", "--folder", folder]

    def refusal(self, row):
        if self.settings:
            return f"the attack has no settings: leave out --set {self.settings[0]}"
        return super().refusal(row)

    def run(self, job):
        row, first, count = job
        began = time.monotonic()
        with tempfile.TemporaryDirectory() as folder:
            done = self.call([*self.command(row, first)[1:], "--jobs", "1", "--quiet", "--folder", folder], 40000)
            state = next(pathlib.Path(folder).glob("*.state"), None)
            if done is None or state is None:
                return [{"row": row, "seed": first, "status": "crash", "reason": ended(done) if done else "too long"}]
            return [{"row": row, "seed": first, **self.read_state(state.read_text()),
                     "seconds": round(time.monotonic() - began, 2)}]

    @staticmethod
    def read_state(text):
        """The one family that has cases, and the violations as NUMBER KIND, the first with its words."""
        tallies = [[int(word) for word in line.split()[1:]] for line in text.splitlines() if line.startswith("tally ")]
        tally = max(tallies, key=lambda values: values[0])
        head, rest = tally[:len(FIRST_TALLIES)], tally[len(FIRST_TALLIES):]
        found = [line.split(" ", 3)[1:] for line in text.splitlines() if line.startswith("violation ")]
        return {"status": "violation" if found else "ok", "reason": " ".join(found[0]) if found else "",
                **dict(zip(FIRST_TALLIES, head)), "ok": dict(zip(rest[::2], rest[1::2])).get(0, 0),
                "contacts": sum(kind in TOUCHING for _, kind, *_ in found),
                "violations": ";".join(f"{number} {kind}" for number, kind, *_ in found)}

    @staticmethod
    def case(entry):
        """Number and kind of the first violation of a block."""
        return (entry.get("violations") or "0 none").split(";")[0].split(" ")

    def failure(self, entry):
        return self.case(entry)[1]

    def world_file(self, entry):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "obstacles.txt")
            self.call(["--seed", str(self.seed), "--case", self.case(entry)[0], "--write-obstacles", str(path)], 120)
            return path.read_text() if path.exists() else ""

    def status_of(self, path, entry):
        done = self.call(self.file_command(path, entry)[1:], 120)
        if done is None or done.returncode < 0:
            return "too_long" if done is None else "crash"
        kinds = [line.split()[1] for line in done.stdout.splitlines() if line.startswith("violation ")]
        wanted = self.failure(entry)
        return wanted if wanted in kinds else "ok"

    def file_command(self, path, entry):
        return [self.program, "--seed", str(self.seed), "--case", self.case(entry)[0], "--only-obstacles", str(path)]


def run_job(kind, job):
    """At module level, so that another process can be told to do it."""
    return kind.run(job)

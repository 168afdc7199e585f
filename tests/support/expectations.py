# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a test that is a script expects: a line for each expectation, and the exit status."""
failures = 0


def expect(what, held):
    global failures
    failures += not held
    print(f"{'ok' if held else 'FAILED'}: {what}", flush=True)


def status():
    return 1 if failures else 0

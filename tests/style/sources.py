# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""The checkout's own files, with or without git: no build trees, no hidden folders but the ones that code hosts read."""
import os
import pathlib

SKIPPED = {"build", ".git", ".cache", ".vscode", ".idea", "__pycache__"}


def files(root):
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(set(folders) - SKIPPED)
        yield from (pathlib.Path(folder, name) for name in sorted(names))

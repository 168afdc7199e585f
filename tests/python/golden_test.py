# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""The golden hash, through the Python package: the same bits as from C++."""
import pathlib
import re
import unittest

import golden_corpus

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Golden(unittest.TestCase):
    def test_plans_have_the_recorded_hash(self):
        header = (ROOT / "tests/golden/golden_hash.hpp").read_text()
        recorded = int(re.search(r"kGoldenHash = (0x[0-9a-f]+)u", header).group(1), 16)
        self.assertEqual(f"{golden_corpus.corpus_hash(ROOT):016x}", f"{recorded:016x}")


unittest.main()

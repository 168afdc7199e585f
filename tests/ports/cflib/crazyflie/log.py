# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
class LogConfig:
    def __init__(self, name, period_in_ms):
        self.name, self.period_in_ms, self.variables = name, period_in_ms, []

    def add_variable(self, name, fetch_as=None):
        self.variables.append(name)

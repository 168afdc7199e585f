# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
class SyncCrazyflie:
    def __init__(self, link_uri, cf=None):
        self.cf = cf

    def __enter__(self):
        return self

    def __exit__(self, *error):
        pass

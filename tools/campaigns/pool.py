# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Who does the jobs: threads of this process, each of which waits for one program at a time, or the ranks of `mpirun`.
Under MPI, rank 0 hands out jobs and alone writes files; the other ranks only need the program."""
import concurrent.futures
import contextlib
import os
import sys

RANKS = ("OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK")


def under_mpi():
    return any(name in os.environ for name in RANKS)


@contextlib.contextmanager
def workers(jobs):
    """An executor and the number of its workers; None and 0 on ranks that only serve, which stay until all is done."""
    if not under_mpi():
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            yield pool, jobs
        return
    try:
        from mpi4py import MPI
        from mpi4py.futures import MPICommExecutor
    except ImportError:
        sys.exit("tools/campaign: mpirun needs mpi4py for this Python; tools/setup mpi installs Debian's")
    with MPICommExecutor(MPI.COMM_WORLD, root=0) as pool:
        yield pool, max(1, MPI.COMM_WORLD.Get_size() - 1) if pool is not None else 0


def as_they_finish(pool, width, function, items):
    """Results in the order of finishing. Few jobs wait at a time, so that one that ends the campaign ends it soon."""
    waiting, items = set(), iter(items)
    while True:
        for item in items:
            waiting.add(pool.submit(function, *item))
            if len(waiting) >= 2 * width:
                break
        if not waiting:
            return
        done, waiting = concurrent.futures.wait(waiting, return_when=concurrent.futures.FIRST_COMPLETED)
        for future in done:
            yield future.result()

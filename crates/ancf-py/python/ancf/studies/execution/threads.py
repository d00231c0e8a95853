"""Execution of cases on threads, one case per thread at a time."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from queue import Empty, SimpleQueue
from threading import Event, Lock
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

TICK = 0.2
"""Maximum time between two calls of `tick` in seconds."""


def cores() -> int:
    """Return the number of cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def run(
    cases: Sequence[int],
    jobs: int,
    work: Callable[[int, Callable[[], bool]], None],
    tick: Callable[[], None],
) -> None:
    """Run cases on a number of threads. The calling thread calls `tick` after each case and now and then.

    Simulations run without the interpreter lock. An exception in the calling thread, such as `KeyboardInterrupt`,
    ends running cases within a step: the second argument of `work` then returns True.
    """
    queue, lock, stop = iter(cases), Lock(), Event()
    done: SimpleQueue[bool] = SimpleQueue()

    def loop() -> None:
        try:
            while not stop.is_set():
                with lock:
                    case = next(queue, None)
                if case is None:
                    return
                work(case, stop.is_set)
                done.put(False)
        finally:
            done.put(True)

    with ThreadPoolExecutor(max(1, min(jobs, len(cases)))) as pool:
        threads = [pool.submit(loop) for _ in range(min(jobs, len(cases)))]
        running = len(threads)
        try:
            while running:
                with suppress(Empty):
                    running -= done.get(timeout=TICK)
                tick()
        finally:
            stop.set()
    for thread in threads:
        thread.result()

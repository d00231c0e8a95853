"""Cases on the cores of this machine: threads that run one case each at a time."""

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
"""How often `tick` is called if no case ends, in seconds."""


def cores() -> int:
    """How many cores this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def run(
    cases: Sequence[int],
    jobs: int,
    work: Callable[[int, Callable[[], bool]], None],
    tick: Callable[[], None],
) -> None:
    """Run cases on so many threads; `tick` is called here after each, and now and then.

    Simulations run without Python's lock. What is raised here, such as `KeyboardInterrupt`, ends those that run
    within a step, which is what the second argument of `work` is for.
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

"""Cases on the cores of this machine: threads that run one case each at a time."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from queue import Empty, SimpleQueue
from threading import Event, Lock
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from ancf.studies.row import Row

TICK = 0.2
"""How often the receiver is called if no case ends, in seconds."""


def cores() -> int:
    """How many cores this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def run(
    cases: Sequence[int],
    jobs: int,
    work: Callable[[int, Callable[[], bool]], Row],
    receive: Callable[[int | None, Row | None], None],
) -> None:
    """Run cases on so many threads and hand on each row as it comes; `None` now and then, if none comes.

    Simulations run without Python's lock. What is raised here, such as `KeyboardInterrupt`, ends those that run
    within a step; their rows are handed on before it is raised again.
    """
    queue, lock, stop = iter(cases), Lock(), Event()
    done: SimpleQueue[tuple[int | None, Row | None]] = SimpleQueue()

    def loop() -> None:
        try:
            while not stop.is_set():
                with lock:
                    case = next(queue, None)
                if case is None:
                    return
                done.put((case, work(case, stop.is_set)))
        finally:
            done.put((None, None))

    with ThreadPoolExecutor(max(1, min(jobs, len(cases)))) as pool:
        threads = [pool.submit(loop) for _ in range(min(jobs, len(cases)))]
        running = len(threads)
        try:
            while running:
                try:
                    case, row = done.get(timeout=TICK)
                except Empty:
                    case, row = None, None
                else:
                    running -= case is None
                receive(case, row)
        except BaseException:
            stop.set()
            pool.shutdown()
            while not done.empty():
                receive(*done.get())
            raise
    for thread in threads:
        thread.result()

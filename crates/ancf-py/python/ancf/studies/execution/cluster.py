"""Cases on a cluster of `dask.distributed`."""

from __future__ import annotations

from collections import deque
from concurrent.futures import CancelledError
from functools import lru_cache
from queue import Empty, SimpleQueue
from time import perf_counter
from typing import TYPE_CHECKING, Any

from ancf.studies.row import Row

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from ancf.studies.row import Work

TICK = 0.2
"""How often `tick` is called if no case ends, in seconds."""

LENGTH = 0.5
"""How long a task should take, in seconds: many times of what the scheduler does for it."""

COUNTED = 1.0
"""How often threads are counted, in seconds."""

TRIES = 3
"""How often a case is sent out whose tasks end without an answer."""

Values = dict[str, Any]


def run(
    client: Any,
    cases: Sequence[int],
    work: Work,
    values: Callable[[int], Values],
    add: Callable[[int, Row], None],
    tick: Callable[[], None],
) -> None:
    """Run cases on the workers of a client and add each row as it comes; `tick` is called then, and now and then.

    Tasks have as many cases as take about half a second, and a few of them wait for each worker. The scheduler
    runs those again whose worker dies. If it gives a task up, since several of its workers died, its cases go out
    again when nothing else is out, one after the other: which of them it was is known then, and becomes a row.
    """
    import cloudpickle

    flight = Flight(client, cloudpickle.dumps(work), values)
    waiting = deque(cases)
    try:
        while waiting or flight.tasks or flight.suspects:
            if not waiting and not flight.tasks:
                flight.send([flight.suspects.pop()], TRIES)
            while waiting and flight.has_room():
                size = min(flight.size, 1 + len(waiting) // (4 * flight.threads()))
                flight.send([waiting.popleft() for _ in range(size)])
            flight.land(add)
            tick()
    except BaseException:
        if client.status == "running":
            client.cancel([future for future, _, _ in flight.tasks.values()])
        raise


@lru_cache(maxsize=4)
def unpacked(packed: bytes) -> Work:
    """The work that came to a worker."""
    import cloudpickle

    work: Work = cloudpickle.loads(packed)
    return work


def rows(packed: bytes, batch: Sequence[Mapping[str, Any]]) -> list[Row]:
    """Run some cases on a worker."""
    work = unpacked(packed)
    return [work.row(values) for values in batch]


class Flight:
    """The tasks that are out."""

    def __init__(self, client: Any, packed: bytes, values: Callable[[int], Values]) -> None:
        """No task is out yet."""
        self.tasks: dict[int, tuple[Any, list[int], int]] = {}
        """Future, cases and number of the try, by the number of the task."""
        self.suspects: list[int] = []
        """Cases whose workers died, maybe of others that they were with."""
        self.size = 1
        """How many cases a task should have."""
        self._client, self._packed, self._values = client, packed, values
        self._landed: SimpleQueue[int] = SimpleQueue()
        self._sent = 0
        self._time, self._count = 0.0, 0
        self._threads, self._counted = 1, -COUNTED

    def threads(self) -> int:
        """Threads of all workers, of which there may be none yet."""
        if perf_counter() - self._counted > COUNTED:
            threads: dict[str, int] = self._client.nthreads()
            self._threads, self._counted = max(1, sum(threads.values())), perf_counter()
        return self._threads

    def has_room(self) -> bool:
        """Whether more should be sent: three tasks a thread, and enough to ask a cluster that adapts for more."""
        return len(self.tasks) < 16 or len(self.tasks) < 3 * self.threads()

    def send(self, cases: list[int], trial: int = 1) -> None:
        """Send cases out."""
        if self._client.status not in {"running", "connecting"}:
            msg = f"the client of the cluster is {self._client.status}"
            raise RuntimeError(msg)
        number = self._sent
        self._sent += 1
        batch = [self._values(case) for case in cases]
        future = self._client.submit(rows, self._packed, batch, pure=False)
        self.tasks[number] = (future, cases, trial)
        future.add_done_callback(lambda _: self._landed.put(number))

    def land(self, add: Callable[[int, Row], None]) -> None:
        """Wait for a task, but not long, and add its rows."""
        try:
            future, cases, trial = self.tasks.pop(self._landed.get(timeout=TICK))
        except Empty:
            return
        try:
            answers: list[Row] = future.result()
        except CancelledError as error:
            msg = "the cluster dropped cases that were out; those that had finished are kept"
            raise RuntimeError(msg) from error
        except Exception as error:  # Whatever a scheduler may tell.
            self._again(cases, trial, error, add)
            return
        self._learn(answers)
        for case, row in zip(cases, answers, strict=True):
            add(case, row)

    def _again(
        self,
        cases: list[int],
        trial: int,
        error: Exception,
        add: Callable[[int, Row], None],
    ) -> None:
        """Send cases out again, each alone, but not for ever."""
        for case in cases:
            if trial >= TRIES:
                add(case, Row("failed", f"{type(error).__name__}: {error}"))
            elif type(error).__name__ == "KilledWorker":
                self.suspects.append(case)
            else:
                self.send([case], trial + 1)

    def _learn(self, answers: list[Row]) -> None:
        """How many cases take as long as a task should."""
        self._time += sum(row.seconds for row in answers)
        self._count += len(answers)
        self.size = max(1, int(LENGTH * self._count / max(self._time, 1e-6)))

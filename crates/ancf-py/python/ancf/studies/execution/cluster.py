"""Execution of cases on a cluster of `dask.distributed`."""

from __future__ import annotations

from collections import deque
from concurrent.futures import CancelledError
from functools import lru_cache
from queue import Empty, SimpleQueue
from time import perf_counter
from typing import TYPE_CHECKING, Any

from ancf.studies.execution.row import Row

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from ancf.studies.execution.row import Work

TICK = 0.2
"""Maximum time between two calls of `tick` in seconds."""

TASK_DURATION = 0.5
"""Target duration of a task in seconds: a large multiple of the cost of scheduling."""

COUNT_INTERVAL = 1.0
"""Minimum time between two counts of threads in seconds."""

MAX_TRIES = 3
"""Maximum number of submissions of a case whose tasks end without an answer."""

Values = dict[str, Any]


def run(
    client: Any,
    cases: Sequence[int],
    work: Work,
    values: Callable[[int], Values],
    add: Callable[[int, Row], None],
    tick: Callable[[], None],
) -> None:
    """Run cases on the workers of a client and add their rows. `tick` is called after each task and now and then.

    A task has as many cases as take about half a second, and a few tasks wait for each worker. The scheduler
    repeats tasks whose worker dies. If it abandons a task, since several workers died, its cases are submitted again
    one at a time, when no other task is running. A case that kills its worker is thus identified and becomes a row.
    """
    import cloudpickle

    queue = TaskQueue(client, cloudpickle.dumps(work), values)
    waiting = deque(cases)
    try:
        while waiting or queue.tasks or queue.suspects:
            if not waiting and not queue.tasks:
                queue.send([queue.suspects.pop()], MAX_TRIES)
            while waiting and queue.has_room():
                size = min(queue.size, 1 + len(waiting) // (4 * queue.threads()))
                queue.send([waiting.popleft() for _ in range(size)])
            queue.receive(add)
            tick()
    except BaseException:
        if client.status == "running":
            client.cancel([future for future, _, _ in queue.tasks.values()])
        raise


@lru_cache(maxsize=4)
def unpacked(packed: bytes) -> Work:
    """Unpickle the work once per worker."""
    import cloudpickle

    work: Work = cloudpickle.loads(packed)
    return work


def rows(packed: bytes, batch: Sequence[Mapping[str, Any]]) -> list[Row]:
    """Run a batch of cases on a worker."""
    work = unpacked(packed)
    return [work.row(values) for values in batch]


class TaskQueue:
    """Submitted tasks."""

    def __init__(self, client: Any, packed: bytes, values: Callable[[int], Values]) -> None:
        """Start without tasks."""
        self.tasks: dict[int, tuple[Any, list[int], int]] = {}
        """Future, cases and number of the submission, by the number of the task."""
        self.suspects: list[int] = []
        """Cases of tasks whose workers died. Each of these tasks has at least one fatal case."""
        self.size = 1
        """Number of cases per task."""
        self._client, self._packed, self._values = client, packed, values
        self._finished: SimpleQueue[int] = SimpleQueue()
        self._sent = 0
        self._time, self._count = 0.0, 0
        self._threads, self._counted = 1, -COUNT_INTERVAL

    def threads(self) -> int:
        """Return the number of threads of all workers, at least 1."""
        if perf_counter() - self._counted > COUNT_INTERVAL:
            threads: dict[str, int] = self._client.nthreads()
            self._threads, self._counted = max(1, sum(threads.values())), perf_counter()
        return self._threads

    def has_room(self) -> bool:
        """Return True for fewer than three tasks per thread, or too few to make an adaptive cluster grow."""
        return len(self.tasks) < 16 or len(self.tasks) < 3 * self.threads()

    def send(self, cases: list[int], trial: int = 1) -> None:
        """Submit a task."""
        if self._client.status not in {"running", "connecting"}:
            msg = f"the client of the cluster is {self._client.status}"
            raise RuntimeError(msg)
        number = self._sent
        self._sent += 1
        batch = [self._values(case) for case in cases]
        future = self._client.submit(rows, self._packed, batch, pure=False)
        self.tasks[number] = (future, cases, trial)
        future.add_done_callback(lambda _: self._finished.put(number))

    def receive(self, add: Callable[[int, Row], None]) -> None:
        """Wait for a task for a short time and add its rows."""
        try:
            future, cases, trial = self.tasks.pop(self._finished.get(timeout=TICK))
        except Empty:
            return
        try:
            answers: list[Row] = future.result()
        except CancelledError as error:
            msg = "the cluster dropped cases that were out; those that had finished are kept"
            raise RuntimeError(msg) from error
        except Exception as error:  # The error depends on the scheduler.
            self._retry(cases, trial, error, add)
            return
        self._update_size(answers)
        for case, row in zip(cases, answers, strict=True):
            add(case, row)

    def _retry(
        self,
        cases: list[int],
        trial: int,
        error: Exception,
        add: Callable[[int, Row], None],
    ) -> None:
        """Submit cases again, each alone, up to the maximum number of submissions."""
        for case in cases:
            if trial >= MAX_TRIES:
                add(case, Row("failed", f"{type(error).__name__}: {error}"))
            elif type(error).__name__ == "KilledWorker":
                self.suspects.append(case)
            else:
                self.send([case], trial + 1)

    def _update_size(self, answers: list[Row]) -> None:
        """Choose the number of cases per task from the mean duration of a case."""
        self._time += sum(row.seconds for row in answers)
        self._count += len(answers)
        self.size = max(1, int(TASK_DURATION * self._count / max(self._time, 1e-6)))

"""Progress bars of runs."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import TracebackType


class Bar:
    """Progress bar of a motion."""

    def __init__(self, duration: float | None, expected: bool | None) -> None:
        """Prepare a bar for a motion of a duration. By default it is shown in terminals and notebooks."""
        self._bar: Any = None
        self._duration = duration
        self._wanted = duration is not None and (is_seen() if expected is None else expected)

    def __enter__(self) -> Bar:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        if self._bar is not None:
            self._bar.close()

    @property
    def tick(self) -> Any:
        """Function to call with the time of the motion now and then. None if there is no bar."""
        return self._tick if self._wanted else None

    def _tick(self, time: float) -> None:
        if self._bar is None:
            # Short runs end before the first tick and show no bar.
            if time <= 0.0:
                return
            from tqdm.auto import tqdm

            form = "{percentage:3.0f}%|{bar}| t = {n:.4g} of {total:.4g} [{elapsed}<{remaining}]"
            self._bar = tqdm(total=self._duration, bar_format=form, leave=False)
        self._bar.update(time - self._bar.n)


def is_seen() -> bool:
    """Return True in a terminal or a notebook."""
    return _in_notebook() or (sys.stderr is not None and sys.stderr.isatty())


def _in_notebook() -> bool:
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return type(shell).__name__ == "ZMQInteractiveShell"

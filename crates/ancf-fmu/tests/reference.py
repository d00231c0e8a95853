"""Runs of the shared library of the C interface: the reference of the FMUs."""

import ctypes as c
import os
from pathlib import Path

MODELS = Path(__file__).parent / "models"


class Reference:
    """Motion of a model by the C interface."""

    def __init__(self, text: str) -> None:
        self._library = c.CDLL(os.environ["ANCF_C_LIBRARY"])
        self._library.ancf_last_error.restype = c.c_char_p
        self._handle = c.c_void_p()
        self._call("ancf_parse", text.encode(), c.byref(self._handle), own=False)

    @classmethod
    def of(cls, path: Path) -> "Reference":
        """Read a model file."""
        return cls(path.read_text(encoding="utf-8"))

    def _call(self, function: str, *arguments: object, own: bool = True) -> None:
        status = getattr(self._library, function)(*((self._handle,) if own else ()), *arguments)
        if status != 0:
            raise RuntimeError(self._library.ancf_last_error().decode())

    def set(self, name: str, value: float, ramp: float = 0.0) -> None:
        """Set an input."""
        index = c.c_size_t()
        self._call("ancf_find_input", name.encode(), c.byref(index))
        self._call("ancf_set_input", index, c.c_double(value), c.c_double(ramp))

    def read(self, name: str) -> float:
        """Value of a column."""
        index, value = c.c_size_t(), c.c_double()
        self._call("ancf_find_column", name.encode(), c.byref(index))
        self._call("ancf_read", index, c.byref(value))
        return value.value

    def advance(self, until: float) -> None:
        """Advance to a time."""
        self._call("ancf_advance", c.c_double(until), None)

    def close(self) -> None:
        """Release the motion."""
        self._library.ancf_close(self._handle)

"""FMUs of the test models, written by the program."""

import os
import subprocess
from collections.abc import Callable

import pytest
from reference import MODELS


@pytest.fixture(scope="session")
def fmu(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., str]:
    """Write an FMU and return its path."""
    folder = tmp_path_factory.mktemp("fmu")

    def write(model: str, version: int, *options: str) -> str:
        path = folder / f"{model}_{version}_{abs(hash(options))}.fmu"
        if not path.exists():
            command = [os.environ["ANCF"], "fmu", str(MODELS / f"{model}.toml"), "-o", str(path)]
            subprocess.run([*command, "--version", str(version), *options], check=True)
        return str(path)

    return write

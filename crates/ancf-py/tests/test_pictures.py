"""Pictures of the documentation: they belong to the present models, are small, and are used."""

import hashlib
import json
from pathlib import Path

ROOT = Path(__file__).parents[3]
FOLDER = ROOT / "docs" / "pictures"
MAX_BYTES = 3_000_000


def test_pictures_belong_to_the_present_models() -> None:
    """A changed model has a new picture: `cargo xtask pictures`."""
    pictures = json.loads((FOLDER / "pictures.json").read_text())
    recorded = json.loads((FOLDER / "checksums.json").read_text())
    models = {picture["model"] for picture in pictures}
    present = {
        name: hashlib.sha256((ROOT / "models" / f"{name}.toml").read_bytes()).hexdigest() for name in models
    }
    assert present == recorded, "run `cargo xtask pictures`"


def test_pictures_are_complete_and_small() -> None:
    """The folder has the listed pictures, 3 MB at most, and the documentation shows each of them."""
    listed = {picture["file"] for picture in json.loads((FOLDER / "pictures.json").read_text())}
    files = {path.name: path for path in FOLDER.glob("*.webp")}
    assert set(files) == listed
    assert sum(path.stat().st_size for path in files.values()) < MAX_BYTES
    pages = "".join(page.read_text() for page in [ROOT / "README.md", ROOT / "docs" / "gallery.md"])
    assert [name for name in listed if f"pictures/{name}" not in pages] == []

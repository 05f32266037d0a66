"""What tests of model files share: files in a folder, their faults, and the joints of a model in short."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from gcrules.core.errors import FileError
from gcrules.mechanisms.models.model import Model
from gcrules.mechanisms.models.reading import read_model

__all__ = ["fault", "joints", "read", "shape"]


def read(folder: Path, text: str, closures: str | None = None, name: str = "model.xml") -> Model:
    """The model of a text, written to a file."""
    file = folder / name
    file.write_text(text, encoding="utf-8")
    beside = None
    if closures is not None:
        beside = folder / "closures.yaml"
        beside.write_text(closures, encoding="utf-8")
    return read_model(file, beside)


def fault(folder: Path, text: str, closures: str | None = None) -> FileError:
    """The fault of a text, which must have one, with what every one has."""
    with pytest.raises(FileError) as found:
        read(folder, text, closures)
    shown = found.value.render()
    assert found.value.exit_code == 2
    assert shown.startswith("error: ")
    return found.value


def shape(model: Model) -> dict[str, tuple[str, str, str]]:
    """Kind and links of each joint."""
    return {j.name: (j.kind, j.parent, j.child) for j in model.joints}


def joints(model: Model, digits: int = 8) -> dict[str, object]:
    """The joints that move or close a loop, in short, to be compared."""
    return {
        j.name: (
            j.kind,
            j.parent,
            j.child,
            tuple(np.round(j.at, digits) + 0.0),
            tuple(tuple(np.round(a, digits) + 0.0) for a in j.axes),
            j.closing,
            j.limits,
        )
        for j in model.joints
        if j.kind != "fixed" or j.closing
    }

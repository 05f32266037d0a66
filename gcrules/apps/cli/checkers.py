"""`gcrules checkers`: the programs that check what gcrules says, for those who have no checkout."""

from __future__ import annotations

from pathlib import Path

import click

from gcrules.core.english import counted
from gcrules.core.errors import FileError
from gcrules.core.files import write_file

__all__ = ["checkers"]


@click.command()
@click.argument("folder", default="checkers")
def checkers(folder: str) -> None:
    """Write the programs that check proof files and certificates into a folder, by default "checkers".

    They need Python alone and share no code with gcrules.

    \b
    gcrules checkers
    python checkers/check_proof.py FILE.json          the theorems of a proof file
    python checkers/recompute.py FILE.json            what does not exist, stated in a proof file
    python checkers/check_certificate.py FILE.json    a certificate of a range
    python checkers/check_map.py FILE.json            what the cells of a map are
    python checkers/check_boxes.py FILE.json          a map of whole boxes
    python checkers/check_free.py FILE.json           a free region
    python checkers/check_plan.py FILE.json           that no way leads from one pose to another
    """
    files = sorted(path for path in _shipped().iterdir() if path.suffix in (".md", ".py"))
    target = Path(folder)
    try:
        target.mkdir(parents=True, exist_ok=True)
    except OSError as fault:
        raise FileError(f"cannot be made: {fault.strerror}", filename=folder) from None
    for path in files:
        write_file(str(target / path.name), path.read_bytes())
    click.echo(f"{folder}: {counted(len(files), 'file')}; README.md there says which program checks what")


def _shipped() -> Path:
    """The folder inside an installed package, or beside the package in a checkout."""
    package = Path(__file__).parents[2]
    inside = package / "_checkers"
    return inside if inside.is_dir() else package.parent / "checkers"

"""Figures of matplotlib as bytes: equal figures give equal bytes, for there are no dates and no installed fonts."""

from __future__ import annotations

from collections.abc import Callable
from io import BytesIO
from threading import Lock
from typing import Any

import matplotlib
from matplotlib.figure import Figure

__all__ = ["saved"]

_SETTINGS: Any = {
    "font.family": "STIXGeneral",
    "font.size": 9.5,
    "mathtext.fontset": "stix",
    "svg.fonttype": "path",
    "svg.hashsalt": "gcrules",
    "pdf.fonttype": 42,
    "axes.linewidth": 0.7,
    "axes.unicode_minus": True,
    "hatch.linewidth": 0.55,
    "text.usetex": False,
}
_SETTING = Lock()  # the settings of matplotlib are global


def saved(make: Callable[[], Figure], title: str, kind: str) -> bytes:
    """The bytes of the figure that is made: svg, pdf or png."""
    out = BytesIO()
    with _SETTING, matplotlib.rc_context(_SETTINGS):
        made = make()
        metadata: dict[str, dict[str, Any]] = {
            "svg": {"Date": None, "Title": title},
            "pdf": {"CreationDate": None, "Title": title},
            "png": {"Title": title},
        }
        made.savefig(out, format=kind, dpi=200, metadata=metadata[kind])
    return out.getvalue()

"""The tree of boxes of a certificate, read from its text, by itself."""

from __future__ import annotations

from collections.abc import Sequence

from gcrules.poses.certificates.certificate import Certificate


def sign_at(c: Certificate, place: Sequence[float]) -> str:
    """What the tree says of a place in the units of the axes."""
    ends = [[float(a.start), float(a.stop)] for a in c.axes]
    tree = iter(c.tree)

    def skip() -> None:
        if next(tree).isdigit():
            skip()
            skip()

    while (sign := next(tree)).isdigit():
        k = int(sign)
        middle = sum(ends[k]) / 2
        upper = place[k] > middle
        ends[k][0 if upper else 1] = middle
        if upper:
            skip()
    return sign

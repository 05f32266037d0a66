"""Over which coordinates a locus is offered: each of them is a question, and no other pair is."""

from __future__ import annotations

from itertools import combinations

import pytest

import gcrules as gc
from gcrules.core.errors import InputError
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.loci.slices import slices, why_no_locus

PAIRS = tuple(combinations(("x", "y", "z", "roll", "pitch", "yaw"), 2))


@pytest.mark.parametrize("name", ["3-rpr", "orthoglide", "gough-stewart"])
def test_pairs_that_are_offered_have_a_locus(name: str) -> None:
    offered = slices(mechanism(name))
    assert offered
    for pair in offered:
        assert gc.locus(name, pair).variables


@pytest.mark.parametrize("name", ["3-rpr", "orthoglide", "3-prs", "gough-stewart", "4-rpr"])
def test_other_pairs_have_none(name: str) -> None:
    m = mechanism(name)
    others = [pair for pair in PAIRS if pair not in slices(m)]
    assert others
    for pair in others:
        with pytest.raises(InputError):
            gc.locus(name, pair)


def test_it_is_said_why_there_is_none_at_all() -> None:
    assert "more actuators than freedoms" in why_no_locus(mechanism("4-rpr"))
    assert why_no_locus(mechanism("3-rps")) == why_no_locus(mechanism("octahedral")) == ""

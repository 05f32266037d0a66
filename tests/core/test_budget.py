"""Budgets: seconds and memory are counted, and what meets no checkpoint is caught by a net."""

from __future__ import annotations

import signal
import threading
from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from itertools import repeat
from math import inf, nan
from typing import Any

import numpy as np
import pytest

import gcrules as gc
from gcrules.core import alarm, budget, memory
from gcrules.core.budget import Count, checkpoint, seconds_left, waiting, watched, within
from gcrules.core.errors import InputError, LimitReached

# --- budgets ---------------------------------------------------------------------------------------------------------


def test_without_a_budget_there_is_no_limit() -> None:
    checkpoint()
    assert seconds_left() == inf


def test_a_budget_inside_another_ends_no_later() -> None:
    with within(seconds=100), within(seconds=1_000) as inner:
        assert inner.left <= 100
        with within(seconds=1):
            assert seconds_left() <= 1
        assert seconds_left() > 1
    assert seconds_left() == inf


@pytest.mark.parametrize("outer", [True, False], ids=["outer", "inner"])
def test_the_budget_that_is_used_up_is_named(outer: bool) -> None:
    seconds = (0, 1_000) if outer else (1_000, 0)
    with within(seconds[0]), within(seconds[1]), pytest.raises(LimitReached, match="more than 0 seconds") as limited:
        checkpoint()
    assert limited.value.exit_code == 3
    assert "--seconds" in (limited.value.hint or "")


def test_grace_is_not_said() -> None:
    with within(0, grace=1_000) as lenient:
        checkpoint()
        assert lenient.left > 0
    with within(1, grace=-1), pytest.raises(LimitReached, match=r"more than 1 second$"):
        checkpoint()


@pytest.mark.parametrize("wrong", [nan, "five", [1]], ids=str)
def test_what_is_no_number_is_refused(wrong: Any) -> None:
    with pytest.raises(InputError, match="is not a number of seconds"), within(wrong):
        pass


SECONDS_OF_ANY_KIND = {"a fraction": Fraction(1, 10**30), "numpy": np.float32(0), "no time": -(10**400)}


@pytest.mark.parametrize("seconds", SECONDS_OF_ANY_KIND.values(), ids=SECONDS_OF_ANY_KIND)
def test_seconds_are_numbers_of_any_kind(seconds: Any) -> None:
    with pytest.raises(LimitReached, match=r"more than \S+ seconds"), within(seconds):
        checkpoint()
    with within(10**400) as budget:
        assert budget.left == inf


def test_a_budget_can_be_cancelled_from_elsewhere() -> None:
    with within() as outer, within():
        thread = threading.Thread(target=outer.cancel)
        thread.start()
        thread.join()
        with pytest.raises(LimitReached, match="cancelled"):  # the inner budget looks at the outer one now and then
            deque(watched(repeat(None), every=1), maxlen=0)


def test_waiting_does_not_count(monkeypatch: pytest.MonkeyPatch) -> None:
    now = [0.0]
    monkeypatch.setattr(budget, "monotonic", lambda: now[0])
    with within(10), within(20) as inner:
        now[0] += 5
        with waiting(), waiting():
            now[0] += 100
            checkpoint()
        assert inner.left == 5
        checkpoint()
        now[0] += 6
        with pytest.raises(LimitReached, match="more than 10 seconds"):
            checkpoint()


def test_progress_goes_to_the_nearest_that_listens() -> None:
    heard: list[str] = []
    with within(progress=heard.append), within() as inner:
        inner.report("half")
    assert heard == ["half"]


def test_memory_is_limited(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(budget, "memory_in_use", lambda: 3 * memory.GIGABYTE)
    with within(memory=4 * memory.GIGABYTE):
        checkpoint()
    with within(memory=2 * memory.GIGABYTE), pytest.raises(LimitReached, match="more than 2 GB of memory") as limited:
        gc.expand("[abcd]")
    assert "GCRULES_MEMORY" in (limited.value.hint or "")


@pytest.mark.parametrize(("asked", "limit"), [("2", 2 * 2**30), ("0.5", 2**29), ("0", None)])
def test_memory_is_asked_for(monkeypatch: pytest.MonkeyPatch, asked: str, limit: int | None) -> None:
    monkeypatch.setenv("GCRULES_MEMORY", asked)
    assert memory.memory_limit() == limit


@pytest.mark.parametrize("asked", ["much", "-1", "nan", "inf"])
def test_memory_that_is_no_number(monkeypatch: pytest.MonkeyPatch, asked: str) -> None:
    monkeypatch.setenv("GCRULES_MEMORY", asked)
    with pytest.raises(InputError, match="expected a number of gigabytes"):
        memory.memory_limit()


def test_memory_has_a_limit_of_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("GCRULES_MEMORY", raising=False)
    found = memory.memory_limit()
    assert found is None or found > memory.memory_in_use() / 2


def test_a_count_says_what_there_is_too_much_of() -> None:
    count = Count(10, "this takes", "trials", "try less")
    count.spend(10)
    with pytest.raises(LimitReached, match="this takes more than 10 trials") as limited:
        count.spend()
    assert limited.value.hint == "try less"


def test_watched_items_are_the_items() -> None:
    with within(seconds=1_000):
        assert list(watched(range(200))) == list(range(200))
    with within(seconds=0), pytest.raises(LimitReached):
        next(watched([1]))


# --- the net ---------------------------------------------------------------------------------------------------------


@pytest.fixture
def quick_net(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(alarm, "GRACE", 0.0)
    monkeypatch.setattr(alarm, "_EVERY", 0.01)


def endless() -> None:
    while True:
        pass


@pytest.mark.usefixtures("quick_net")
def test_the_net_catches_what_meets_no_checkpoint() -> None:
    before = signal.getsignal(signal.SIGALRM)
    with pytest.raises(LimitReached, match="more than 0 seconds"), alarm.limited(0):
        endless()
    assert signal.getsignal(signal.SIGALRM) is before
    assert signal.getitimer(signal.ITIMER_REAL) == (0, 0)


@pytest.mark.usefixtures("quick_net")
def test_the_net_is_gone_behind_the_budget() -> None:
    with alarm.limited(1_000):
        pass
    assert signal.getitimer(signal.ITIMER_REAL) == (0, 0)


@pytest.mark.usefixtures("quick_net")
def test_a_net_inside_another_gives_the_timer_back() -> None:
    """The prompt runs scripts within the time of one input; a plugin is timed within that of a command."""

    def work() -> None:
        with alarm.limited(1_000):
            pass
        with alarm.ringing(lambda frame: None, 1_000, 1_000):
            pass
        endless()

    with pytest.raises(LimitReached, match=r"more than 0\.05 seconds"), alarm.limited(0.05):
        work()
    assert signal.getitimer(signal.ITIMER_REAL) == (0, 0)


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="needs a timer signal")
def test_a_timer_does_not_ring_while_a_block_is_left() -> None:
    """What is raised there would leave the rest undone, and the timer would ring in whatever runs later."""
    rung: list[int] = []
    ended: list[str] = []

    @contextmanager
    def block(times: int) -> Iterator[None]:
        yield
        for _ in range(times):
            signal.raise_signal(signal.SIGALRM)
        ended.append("whole")

    with alarm.ringing(lambda frame: rung.append(1), 1_000, 1_000):
        with block(5):
            signal.raise_signal(signal.SIGALRM)
            assert len(rung) == 1
        assert (len(rung), ended) == (1, ["whole"])
        with block(12):  # that is no way out any more, but work without an end
            pass
    assert len(rung) > 2
    assert signal.getitimer(signal.ITIMER_REAL) == (0, 0)


def test_in_other_threads_there_are_checkpoints_only() -> None:
    found: list[object] = []

    def work() -> None:
        try:
            with alarm.limited(0):
                gc.straighten("[abcd]")
        except LimitReached as limited:
            found.append(limited)

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert found


@pytest.mark.parametrize("each", [True, False])
def test_paced_items(each: bool) -> None:
    assert list(alarm.paced(iter(range(5)), 1_000, each=each)) == list(range(5))
    assert list(alarm.paced(iter(range(5)), None)) == list(range(5))


def test_pacing_counts_what_was_done_before(monkeypatch: pytest.MonkeyPatch) -> None:
    """The clock jumps by 10 s in each item: together they take more than 25, alone none does."""
    now = [0.0]
    monkeypatch.setattr(alarm, "monotonic", lambda: now[0])
    monkeypatch.setattr(budget, "monotonic", lambda: now[0])

    def items() -> Iterator[int]:
        for n in range(5):
            now[0] += 10
            checkpoint()
            yield n

    assert list(alarm.paced(items(), 25, each=True)) == list(range(5))
    found = alarm.paced(items(), 25)
    assert [next(found), next(found)] == [0, 1]
    with pytest.raises(LimitReached):
        next(found)

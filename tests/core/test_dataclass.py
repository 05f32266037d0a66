"""Dataclasses whose methods are made late are those of the standard library."""

from __future__ import annotations

import copy
import dataclasses
import importlib
import inspect
import pickle
import pkgutil
import re
import subprocess
import sys
from functools import cached_property
from threading import Barrier, Thread
from typing import Any

import pytest
from places import ROOT

import gcrules
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import Span

METHODS = ("__init__", "__repr__", "__eq__", "__hash__")


@dataclass(frozen=True)
class Base:
    """Fields with all kinds of defaults."""

    x: int
    y: tuple[int, ...] = (1, 2)
    z: list[int] = dataclasses.field(default_factory=list, compare=False)
    w: int = dataclasses.field(default=4, repr=False)

    @cached_property
    def total(self) -> int:
        return self.x + self.w


@dataclass(frozen=True)
class Derived(Base):
    """One field more, and what follows from the others."""

    v: str = "v"
    u: int = dataclasses.field(init=False, default=0)

    def __post_init__(self) -> None:
        object.__setattr__(self, "u", self.x + 1)


@dataclass(frozen=True)
class Spelt:
    """Its own comparison and text; the hash is that of the fields."""

    x: int

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Spelt)

    def __repr__(self) -> str:
        return "spelt"


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Bare:
    """Compared by identity."""

    x: int


class Plain(Base):
    """A subclass that is no dataclass itself."""


def twin(cls: type) -> type:
    """What the standard library makes of the class."""
    params: Any = vars(cls)["__dataclass_params__"]
    options = {name: getattr(params, name) for name in ("frozen", "eq", "repr", "kw_only") if hasattr(params, name)}
    made = ("__dataclass_fields__", "__dataclass_params__", "__match_args__", "__replace__", *METHODS)
    kept = {n: v for n, v in vars(cls).items() if not _is_made(n, v, cls, made)}
    for field in vars(cls)["__dataclass_fields__"].values():
        if field.name in inspect.get_annotations(cls):
            kept[field.name] = dataclasses.field(
                default=field.default,
                default_factory=field.default_factory,
                **{n: getattr(field, n) for n in ("init", "repr", "hash", "compare", "kw_only")},
            )
    return dataclasses.dataclass(**options)(type(cls)(cls.__name__, cls.__bases__, kept))


def _is_made(name: str, value: Any, cls: type, made: tuple[str, ...]) -> bool:
    """Whether a name of a class is none that its writer wrote."""
    if name in ("__dict__", "__weakref__", "__setattr__", "__delattr__"):
        return True
    source = getattr(inspect.unwrap(value) if callable(value) else value, "__code__", None)
    return name in made and (source is None or source.co_filename == "<string>")


def late() -> list[type]:
    """All classes of gcrules with methods that are made late."""
    for module in pkgutil.walk_packages(gcrules.__path__, "gcrules."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)
    found = {
        value: None
        for name, module in sorted(sys.modules.items())
        if name.startswith("gcrules.")
        for value in vars(module).values()
        if isinstance(value, type) and value.__module__ == name and _is_late(value)
    }
    return list(found)


def _is_late(cls: type) -> bool:
    return (
        "__dataclass_fields__" in vars(cls) and getattr(cls.__setattr__, "__module__", "") == "gcrules.core.dataclass"
    )


def code(function: Any) -> Any:
    body = inspect.unwrap(function).__code__
    return body.co_code, body.co_names, body.co_varnames, body.co_consts, body.co_freevars


def compared(cls: type) -> None:
    """The class says and does what its twin does."""
    cls.__init__, cls.__repr__, cls.__eq__, cls.__hash__  # noqa: B018  (makes them)
    other = twin(cls)
    for name in METHODS:
        here, there = getattr(cls, name), getattr(other, name)
        if name in vars(cls) and vars(cls)[name] is not None and code(here)[0]:
            assert code(here) == code(there), (cls, name)
        else:
            assert here is there or name not in vars(other), (cls, name)
    assert str(vars(cls)["__dataclass_params__"]) == str(vars(other)["__dataclass_params__"])
    assert str(inspect.signature(cls)) == str(inspect.signature(other))
    assert cls.__match_args__ == other.__match_args__  # type: ignore[attr-defined]
    for here, there in zip(dataclasses.fields(cls), dataclasses.fields(other), strict=True):
        assert str(here) == str(there), cls
        assert getattr(cls, here.name, "none") is getattr(other, here.name, "none"), (cls, here.name)


def test_every_class_is_what_the_standard_library_makes() -> None:
    classes = late()
    assert len(classes) > 300
    for cls in (*classes, Base, Derived, Spelt, Bare):
        compared(cls)


def test_the_modules_take_no_other_dataclass() -> None:
    sources = {p: p.read_text(encoding="utf-8") for p in (ROOT / "gcrules").rglob("*.py")}
    taken = [p for p, text in sources.items() if re.search(r"^from dataclasses import (.*\b)?dataclass\b", text, re.M)]
    assert not taken


def test_values() -> None:
    value = Derived(1, v="a")
    assert value == Derived(1, v="a") != Derived(2, v="a")
    assert value != Base(1)
    assert hash(value) == hash(Derived(1, z=[3], v="a"))
    assert repr(value) == "Derived(x=1, y=(1, 2), z=[], v='a', u=2)"
    assert dataclasses.asdict(value) == {"x": 1, "y": (1, 2), "z": [], "w": 4, "v": "a", "u": 2}
    assert dataclasses.replace(value, x=5).u == 6
    assert value.total == 5
    match value:
        case Derived(x, y):
            assert (x, y) == (1, (1, 2))
        case _:
            pytest.fail("no match")
    assert repr(Spelt(1)) == "spelt"
    assert Spelt(1) == Spelt(2)
    assert hash(Spelt(1)) == hash((1,))
    assert Bare(x=1) != Bare(x=1)
    with pytest.raises(TypeError, match="missing 1 required positional argument: 'x'"):
        Base()  # type: ignore[call-arg]


@pytest.mark.parametrize("value", [Base(1), Derived(1), Spelt(1), Plain(1)], ids=lambda v: type(v).__name__)
def test_copies(value: Any) -> None:
    for other in (copy.copy(value), copy.deepcopy(value), pickle.loads(pickle.dumps(value))):
        assert type(other) is type(value)
        assert other == value


def test_nothing_is_assigned_or_deleted() -> None:
    for value in (Base(1), Derived(1)):
        for name in ("x", "new"):
            with pytest.raises(dataclasses.FrozenInstanceError, match=f"cannot assign to field '{name}'"):
                setattr(value, name, 2)
            with pytest.raises(dataclasses.FrozenInstanceError, match=f"cannot delete field '{name}'"):
                delattr(value, name)
    plain = Plain(1)
    plain.other = 2  # type: ignore[attr-defined]
    del plain.other  # type: ignore[attr-defined]
    with pytest.raises(dataclasses.FrozenInstanceError):
        plain.x = 2


def test_a_value_that_is_unpickled_first() -> None:
    """Where no value of the class was made before."""
    program = (
        "import pickle, sys; value = pickle.loads(sys.stdin.buffer.read()); print(value == value, hash(value), value)"
    )

    done = subprocess.run(
        [sys.executable, "-c", program], input=pickle.dumps(Span(1, 2)), capture_output=True, check=True, cwd=ROOT
    )
    assert done.stdout.decode().strip() == f"True {hash(Span(1, 2))} {Span(1, 2)}"


def test_many_threads_at_once() -> None:
    for _ in range(50):

        @dataclass(frozen=True)
        class Fresh:
            """Nobody has used it yet."""

            x: int
            y: list[int] = dataclasses.field(default_factory=list)

        together = Barrier(4)
        seen: list[Any] = []

        def use(cls: Any = Fresh, together: Barrier = together, seen: list[Any] = seen) -> None:
            together.wait()
            seen.append((cls(1) == cls(1), hash(cls.__match_args__), repr(cls(2))[-12:]))

        threads = [Thread(target=use) for _ in range(4)]
        for t in threads:
            t.start()
        for t in threads:
            t.join()
        assert len(seen) == 4
        assert len(set(seen)) == 1
        assert seen[0][0]

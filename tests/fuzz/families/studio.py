"""What pages and others send to the studio: messages, and requests for files, to its session and its guard.

No server listens: the session speaks with a socket that is a list, and the workers' jobs are done in this process.
"""

from __future__ import annotations

import asyncio
import json
import re
from collections import Counter
from collections.abc import Callable
from concurrent.futures import Executor, Future
from functools import cache
from random import Random
from typing import Any

from ..case import Case
from ..corpus import corpus
from ..grammar import WORDS, Grammar, legs, script
from ..jail import Jail
from ..mutating import mutated, mutated_numbers
from ..running import Outcome, run_call
from .family import Family

__all__ = ["STUDIO"]

_HOME = {"translation": [0, 0, 0], "quaternion": [1, 0, 0, 0]}
_JSON: tuple[Any, ...] = (
    None,
    True,
    0,
    -1,
    1e308,
    2**53 + 1,
    "",
    "x",
    "\0",
    "a" * 300,
    [],
    {},
    [[]],
    {"kind": "class"},
    "\ud800",
)


def _source(rng: Random) -> Any:
    kind = rng.choices(("legs", "example", "class", "robot", "file", "odd"), (4, 4, 3, 1, 3, 1))[0]
    match kind:
        case "legs":
            return {"kind": "legs", "legs": rng.choice(("ab af cb cd ed ef", "Aa Ab Bc Bd Ce Cf", legs(rng)))}
        case "example":
            return {"kind": "example", "name": rng.choice(("octahedral", "octahedral-singular", "four-dof", "no"))}
        case "class":
            return {"kind": "class", "id": rng.choice(("3-3.3", "6-6", "6-3.2", "9-9"))}
        case "robot":
            return {"kind": "robot", "id": rng.choice(("3-rpr", "3-rps", "no"))}
        case "file":
            text = mutated_numbers(rng, rng.choice((*corpus("platforms"), corpus("robots")[4])))
            return {"kind": "file", "text": mutated(rng, text) if rng.random() < 0.3 else text, "name": "f.yaml"}
    return rng.choice(_JSON)


def _pose(rng: Random) -> Any:
    def number() -> float:
        return rng.choice((0, 0.1, -1, 10, 1e6, 1e12, 1e-12, 3))

    pose = {
        "translation": [number() for _ in range(3)],
        "quaternion": [rng.choice((1, 0, 0.5, -0.3)) for _ in range(4)],
    }
    return pose | (
        {"coordinates": [rng.choice((0, 0.01, 1)) for _ in range(rng.choice((3, 6)))]} if rng.random() < 0.2 else {}
    )


def _range(rng: Random) -> str:
    name = rng.choice(("x", "y", "z", "yaw", "rx", "zyx1", "tilt", "q1", "q2", "w", ""))
    ends = rng.choice(("-1:1", "1:-1", "0:0", "nan:1", "-1e9:1e9", "0:1/3", "a:b"))
    return f"{name} {ends}:{rng.choice((2, 3, 5, 1, 0, 10**6))}{rng.choice(('', ' deg', ' rad', ' mm'))}"


def _message(rng: Random, number: int) -> str:
    known = rng.choice(("ab af cb cd ed ef", "Aa Ab Bc Bd Ce Cf"))
    cheap = {"kind": "legs", "legs": known} if rng.random() < 0.6 else _source(rng)
    do = rng.choices(
        (
            "hello",
            "gallery",
            "open",
            "pose",
            "along",
            "path",
            "map",
            "place",
            "here",
            "surface",
            "manual",
            "bench",
            "compose",
            "limbs",
            "save",
            "cancel",
            "x",
        ),
        (1, 0.02, 1.5, 5, 2, 0.5, 0.5, 0.5, 0.5, 0.3, 2, 5, 2, 2, 1.5, 1, 0.5),
    )[0]
    args: dict[str, Any] = {}
    match do:
        case "open":
            args = {"source": _source(rng)}
        case "pose":
            args = {"source": cheap, "pose": _pose(rng)}
        case "along":
            args = {"source": cheap, "poses": [_pose(rng) for _ in range(rng.randint(0, 3))]}
        case "path":
            to = rng.choice(("z=0.1", "x=0.1, y=0, yaw=20deg", "home", "x=nan", "x", "1 2 3", "z=1e400", "q1=1"))
            args = {"source": cheap, "goal": _pose(rng), "start": _pose(rng), "to": to}
            for name in rng.sample(("start", "to"), rng.randint(0, 2)):
                del args[name]
        case "map" | "place" | "here" | "surface":
            args = {
                "source": cheap,
                "over": [_range(rng) for _ in range(3 if do == "surface" else 2)],
                "pose": _pose(rng),
            }
            if do == "place":
                args["place"] = [rng.choice((0, 0.5, -1, 1e9)) for _ in range(2)]
        case "manual":
            words = ("plane abc", "plane abd", "auto", "undo", "x", "shortest", "hint", "condition [abcd]", "form 16")
            args = {"source": cheap, "commands": [rng.choice(words) for _ in range(rng.randint(0, 3))]}
        case "bench":
            g = Grammar.drawn(rng)
            text = rng.choice((g.extensor(rng.randint(0, 1), 1), g.equation(1), script(rng), "let p = ab"))
            args = {"text": mutated(rng, text, WORDS) if rng.random() < 0.3 else text}
            if rng.random() < 0.2:
                args |= {"source": cheap, "pose": _pose(rng)}
            if rng.random() < 0.2:
                sound = "rule r: ab /\\ cde => [acde] b - [bcde] a"
                rule = rng.choice((sound, "rule r: ab => ba", "rule", script(rng)))
                args["rules"] = [{"name": "x.gca", "text": mutated(rng, rule, WORDS), "off": rng.choice(([], ["r"]))}]
        case "compose":
            points = {n: [rng.choice((0, 1, -2, 0.5, 1e9)) for _ in range(3)] for n in "abcdef"}
            drawn = [["a", "b"], ["a", "f"], ["c", "b"], ["c", "d"], ["e", "d"], ["e", "f"]]
            args = {
                "drawing": {"title": "", "points": points, "base": list("ace"), "platform": list("bdf"), "legs": drawn}
            }
        case "limbs":
            args = _limbs(rng)
        case "save":
            args = {
                "source": cheap,
                "pose": _pose(rng),
                "what": rng.choice(("yaml", "json", "html", "latex", "svg", "x")),
            }
        case "cancel":
            args = {"target": rng.randint(0, 4)}
    if rng.random() < 0.1 and do in ("pose", "along", "path", "map", "save"):
        args["threshold"] = rng.choice(("1 deg", "x", "5 mm", "-1 deg", 3))
    message: Any = {"id": number, "do": do, "args": args}
    if rng.random() < 0.15:
        message["channel"] = rng.choice(("c", "d", "", 3))
    if rng.random() < 0.2:
        message = _spoilt(rng, message)
    try:
        text = json.dumps(message)
    except ValueError:  # spoilt so that it holds itself: no page can send it
        text = "{}"
    return mutated(rng, text, ("null", "{", "[", '"id"', "NaN", "1e999"), most=1) if rng.random() < 0.1 else text


def _limbs(rng: Random) -> dict[str, Any]:
    """A robot file, sound or not, and a change of it."""
    from gcrules.mechanisms.editing.edits import EDITS
    from gcrules.mechanisms.editing.sheet import FIRST

    text = rng.choice((*FIRST.values(), *corpus("robots")))
    edit = {
        "do": rng.choice(tuple(EDITS)),
        "name": rng.choice(("A1", "A%", "S1", "r1", "x", "q")),
        "text": rng.choice(
            ("R", "P", "UP*S", "R*4S", "Pa", "*", "*1", "A1", "free", "q9", "B1 A1", "direction", "a b", "")
        ),
        "texts": [rng.choice(("0", "1", "-1.5", "1/3", "1/0", "")) for _ in range(3)],
        "degrees": rng.choice((0, 60, 120, -45)),
        "follow": rng.random() < 0.5,
        **{place: rng.choice((0, 0, 1, 2, 6)) for place in ("limb", "chain", "joint", "part", "to")},
    }
    return {"text": mutated(rng, text) if rng.random() < 0.3 else text, "edit": edit}


def _spoilt(rng: Random, message: Any) -> Any:
    """One value somewhere is another, is missing, or is one too many."""
    at = message
    while (isinstance(at, dict) and at) or (isinstance(at, list) and at):
        key = rng.choice(list(at)) if isinstance(at, dict) else rng.randrange(len(at))
        if rng.random() < 0.35 or not isinstance(at[key], (dict, list)) or not at[key]:
            if rng.random() < 0.3:
                del at[key]
            elif rng.random() < 0.2 and isinstance(at, dict):
                at[rng.choice(("x", "id", "__proto__", ""))] = rng.choice(_JSON)
            else:
                at[key] = rng.choice(_JSON)
            break
        at = at[key]
    return message


_PLACES = (
    "/",
    "/index.html",
    "/ws",
    "/..",
    "/%2e%2e/%2e%2e/etc/passwd",
    "/../gcrules/apps/cli/__init__.py",
    "//",
    "/a\0b",
    "/x" * 999,
    "/assets/",
)
_HEADERS = (
    *(("host", "127.0.0.1:8747"), ("host", "localhost:8747"), ("host", "evil.example"), ("host", ""), ("host", "\xff")),
    *(("origin", "http://127.0.0.1:8747"), ("origin", "null"), ("origin", "http://evil.example"), ("cookie", "=;=;")),
    *(
        ("cookie", f"gcrules-studio={'x' * 43}"),
        ("cookie", "gcrules-studio=\xe9"),
        ("cookie", 'a="\\'),
        ("range", "bytes=0-"),
    ),
    *(("accept-encoding", "gzip"), ("if-none-match", '"x"'), ("upgrade", "websocket"), ("content-length", "-1")),
)


def _request(rng: Random) -> dict[str, Any]:
    drawn = [rng.choice(_HEADERS[:2]), *rng.sample(_HEADERS, rng.randint(0, 3))] if rng.random() < 0.8 else []
    query = rng.choice(("", "", f"token={'x' * 43}", "token=", "ticket=t", "token=%ff", "token=é", "&&&=", "%00"))
    return {
        "method": rng.choice(("GET", "GET", "HEAD", "POST", "X")),
        "path": rng.choice(_PLACES),
        "query": query,
        "headers": [list(h) for h in drawn],
    }


def studio(rng: Random) -> Case:
    if rng.random() < 0.2:
        return Case("studio", data={"requests": [_request(rng) for _ in range(3)]})
    return Case("studio", seconds=60.0, data={"messages": [_message(rng, n) for n in range(1, rng.randint(2, 5))]})


# --- a studio without a network ------------------------------------------------------------------------------------


class _Here(Executor):
    """Does at once what is asked for."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        done: Future[Any] = Future()
        try:
            done.set_result(fn(*args, **kwargs))
        except BaseException as fault:
            done.set_exception(fault)
        return done


class _Pool:
    """What a worker does, in this process; answers go through the pipe's form."""

    def __init__(self) -> None:
        self.known: dict[str, Any] = {}

    async def run(self, job: Any, seconds: float, tell: Callable[[str], None]) -> tuple[Any, Any]:
        import pickle

        from gcrules.apps.studio.pool import WorkerFault
        from gcrules.apps.studio.worker import done

        await asyncio.sleep(0)
        kind, value, subject = pickle.loads(pickle.dumps(done(job, self.known, tell)))
        if kind == "fault":
            raise WorkerFault(value)
        return value, subject


class _Socket:
    """Says these messages, and keeps what is answered."""

    def __init__(self, messages: list[str]) -> None:
        self.messages = [{"type": "websocket.receive", "text": m} for m in messages]
        self.answers: list[str] = []
        self.waiting = len(messages)

    async def accept(self) -> None:
        return

    async def receive(self) -> dict[str, Any]:
        if self.messages:
            return self.messages.pop(0)
        for _ in range(10_000):
            if sum("ok" in json.loads(a) for a in self.answers) >= self.waiting:
                break
            await asyncio.sleep(0)
        return {"type": "websocket.disconnect"}

    async def send_text(self, data: str) -> None:
        self.answers.append(data)


@cache
def _service() -> Any:
    from gcrules.apps.studio.service import Service

    service = Service(None)
    service.pool = _Pool()  # type: ignore[assignment]
    service.numbers.shutdown()
    service.numbers = _Here()  # type: ignore[assignment]
    return service


@cache
def _app() -> Any:
    from gcrules.apps.studio.app import make_app

    return make_app(8747, "x" * 43, None, ("t",))


def run(case: Case, jail: Jail) -> Outcome:
    ask = _talked if "messages" in case.data else _asked
    return run_call(case, jail, lambda: asyncio.run(ask(case.data)))


async def _talked(data: Any) -> list[str]:
    """Every message gets one answer, each is JSON, and none is a fault of gcrules."""
    from gcrules.apps.studio.session import PageSession

    socket = _Socket(data["messages"])
    await PageSession(socket, _service()).run()
    answers = [json.loads(a, parse_constant=_never) for a in socket.answers]
    last = [a for a in answers if "ok" in a]
    wrong = [
        f"a fault of gcrules: {a['error']['message']}" for a in last if not a["ok"] and a["error"]["kind"] == "fault"
    ]
    twice = [n for n, times in Counter(a["id"] for a in last if a["id"]).items() if times > _said(data["messages"], n)]
    if len(last) != len(data["messages"]):
        wrong.append(f"not one answer to each message: {len(last)} to {len(data['messages'])}")
    return wrong + [f"two answers to one message: {n}" for n in twice]


def _said(messages: list[str], number: int) -> int:
    """How many messages bear this number, as a browser reads it: beyond 2^53 two numbers can be one."""
    return sum(float(word) == number for m in messages for word in re.findall(r'"id": (-?\d+)', m)) or 1


def _never(word: str) -> Any:
    raise ValueError(f"{word} is no JSON")


async def _asked(data: Any) -> list[str]:
    """Requests for files: an answer that is no fault of the server, and no file from elsewhere."""
    wrong = []
    for asked in data["requests"]:
        sent: list[Any] = []
        scope = {
            "type": "http", "asgi": {"version": "3.0"}, "http_version": "1.1", "scheme": "http", "root_path": "",
            "method": asked["method"], "path": asked["path"], "raw_path": asked["path"].encode("utf-8", "replace"),
            "query_string": asked["query"].encode("latin-1"), "client": ("127.0.0.1", 1), "server": ("127.0.0.1", 8747),
            "headers": [(k.encode(), v.encode("latin-1")) for k, v in asked["headers"]],
        }  # fmt: skip

        async def receive() -> Any:
            return {"type": "http.request", "body": b"", "more_body": False}

        async def send(message: Any, sent: list[Any] = sent) -> None:
            sent.append(message)

        await _app()(scope, receive, send)
        status = sent[0]["status"] if sent else 0
        body = b"".join(m.get("body", b"") for m in sent)
        if not 200 <= status < 500:
            wrong.append(f"status {status}")
        if b"from __future__" in body or b"root:" in body:
            wrong.append("a file from elsewhere is served")
    return wrong


STUDIO = Family("studio", "messages of pages, and requests for files", studio, run, share=1.5, few=30)

"""The studio's server: whom it turns away, what it serves, and how its token is kept."""

from __future__ import annotations

import os
import re
import stat
import sys
import warnings
from pathlib import Path

import pytest

import gcrules as gc
from gcrules.core.errors import FileError

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

with warnings.catch_warnings():  # it says which client it will use one day
    warnings.simplefilter("ignore")
    from starlette.testclient import TestClient
from apps.studio_client import HERE, KNOWN, OWN, PORT, TOKEN, Page
from starlette.websockets import WebSocketDisconnect

from gcrules.apps.studio import token_file
from gcrules.apps.studio.app import make_app
from gcrules.apps.studio.guard import COOKIE
from gcrules.apps.studio.pages import Pages

# --- who may speak -------------------------------------------------------------------------------------------------

STRANGERS = {
    "no token": HERE,
    "wrong token": HERE | {"cookie": f"{COOKIE}={'y' * 43}"},
    "empty token": HERE | {"cookie": f"{COOKIE}="},
    "broken cookie": HERE | {"cookie": ';;="'},
    "other origin": KNOWN | {"origin": "http://evil.example"},
    "origin null": KNOWN | {"origin": "null"},
    "origin of another port": KNOWN | {"origin": "http://127.0.0.1:1"},
    "origin by https": KNOWN | {"origin": f"https://127.0.0.1:{PORT}"},
    "origin that begins alike": KNOWN | {"origin": f"{OWN}.evil.example"},
    "origin of the other name": KNOWN | {"origin": f"http://localhost:{PORT}"},
    "no origin": {"host": HERE["host"], "cookie": KNOWN["cookie"]},
    "other host": KNOWN | {"host": f"evil.example:{PORT}", "origin": f"http://evil.example:{PORT}"},
    "host of another port": KNOWN | {"host": "127.0.0.1:1", "origin": "http://127.0.0.1:1"},
    "host without a port": KNOWN | {"host": "127.0.0.1", "origin": "http://127.0.0.1"},
}


@pytest.mark.parametrize("name", STRANGERS)
def test_strangers_get_no_websocket(client: TestClient, name: str) -> None:
    with pytest.raises(WebSocketDisconnect), client.websocket_connect("/ws", headers=STRANGERS[name]):
        pass


def test_localhost_is_a_name_of_its_own(client: TestClient) -> None:
    named = KNOWN | {"host": f"localhost:{PORT}", "origin": f"http://localhost:{PORT}"}
    with client.websocket_connect("/ws", headers=named) as socket:
        assert Page(socket).ask("hello")["version"] == gc.__version__


def test_token_becomes_a_cookie(client: TestClient) -> None:
    assert client.get("/").status_code == 403
    assert client.get("/?token=wrong").status_code == 403
    answer = client.get(f"/?token={TOKEN}", follow_redirects=False)
    assert (answer.status_code, answer.headers["location"]) == (303, "/")
    cookie = answer.headers["set-cookie"].lower()
    assert "httponly" in cookie
    assert "samesite=strict" in cookie
    client.cookies.clear()


def test_ticket_is_good_once() -> None:
    client = TestClient(make_app(PORT, TOKEN, tickets={"t" * 43}), base_url=OWN)
    assert [client.get(f"/?ticket={t}").status_code for t in ("", "x", "t" * 42, TOKEN)] == [403] * 4
    answer = client.get(f"/?ticket={'t' * 43}", follow_redirects=False)
    assert (answer.status_code, answer.headers["location"]) == (303, "/")
    assert TOKEN in answer.headers["set-cookie"]
    client.cookies.clear()
    assert client.get(f"/?ticket={'t' * 43}").status_code == 403


def test_port_that_browsers_leave_out() -> None:
    client = TestClient(make_app(80, TOKEN), base_url="http://127.0.0.1")
    known = {"cookie": KNOWN["cookie"], "origin": "http://127.0.0.1"}
    assert client.get("/studio.js", headers=known | {"host": "127.0.0.1"}).status_code == 200
    assert client.get("/studio.js", headers=known | {"host": f"127.0.0.1:{PORT}"}).status_code == 421


@pytest.mark.parametrize(
    ("path", "headers", "status"),
    [
        ("/", {"host": "evil.example"}, 421),
        ("/studio.js", {"host": f"evil.example:{PORT}"}, 421),
        ("/studio.js", {"origin": "http://evil.example"}, 403),
        ("/../pyproject.toml", {}, 404),
        ("/%2e%2e/app.py", {}, 404),
        ("/..%2fapp.py", {}, 404),
        ("//etc/passwd", {}, 404),
        ("/fonts/", {}, 404),
        ("/static/index.html", {}, 404),
    ],
)
def test_nothing_else_is_served(client: TestClient, path: str, headers: dict[str, str], status: int) -> None:
    assert client.get(path, headers=headers | {"cookie": KNOWN["cookie"]}).status_code == status


def test_only_get_is_served(client: TestClient) -> None:
    for method in ("POST", "PUT", "DELETE", "OPTIONS"):
        assert client.request(method, "/", headers={"cookie": KNOWN["cookie"]}).status_code == 405


def test_files_have_types_tags_and_a_policy(client: TestClient, tmp_path: Path) -> None:
    from starlette.applications import Starlette
    from starlette.routing import Route

    (tmp_path / "fonts").mkdir()
    for name in ("index.html", "studio.js", "studio.css", "fonts/a.woff2", "secret.pem"):
        (tmp_path / name).write_text(name)
    pages = Pages(tmp_path)
    app = Starlette(routes=[Route("/", pages.answer), Route("/{name:path}", pages.answer)])
    served = TestClient(app, base_url=OWN)
    types = {
        "/": "text/html",
        "/studio.js": "text/javascript",
        "/studio.css": "text/css",
        "/fonts/a.woff2": "font/woff2",
    }
    for path, mime in types.items():
        answer = served.get(path)
        assert answer.headers["content-type"].startswith(mime)
        assert served.get(path, headers={"if-none-match": answer.headers["etag"]}).status_code == 304
    assert served.get("/secret.pem").status_code == 404
    (tmp_path / "studio.js").write_text("changed")
    os.utime(tmp_path / "studio.js", ns=(1, 1))
    assert served.get("/studio.js").text == "changed"
    policy = client.get("/").headers["content-security-policy"]
    assert "default-src 'self'" in policy
    assert "unsafe-eval" not in policy
    assert "script-src 'self';" in policy


# --- the token's file ----------------------------------------------------------------------------------------------

needs_modes = pytest.mark.skipif(sys.platform == "win32", reason="needs modes of files")


def test_token_is_kept(tmp_path: Path) -> None:
    first = token_file.token(tmp_path / "state")
    assert re.fullmatch(r"[\w-]{43}", first)
    assert token_file.token(tmp_path / "state") == first
    assert token_file.token(tmp_path / "other") != first
    assert [p.name for p in (tmp_path / "state").iterdir()] == ["studio-token"]


@needs_modes
def test_token_is_for_the_user_alone(tmp_path: Path) -> None:
    first = token_file.token(tmp_path)
    path = tmp_path / "studio-token"
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    path.chmod(0o644)
    second = token_file.token(tmp_path)
    assert second != first
    assert stat.S_IMODE(path.stat().st_mode) == 0o600


@needs_modes
@pytest.mark.parametrize("text", ["", "short", "x" * 44, "\xff" * 43])
def test_token_file_at_fault_is_made_anew(tmp_path: Path, text: str) -> None:
    path = tmp_path / "studio-token"
    path.write_bytes(text.encode("latin-1"))
    path.chmod(0o600)
    assert token_file.token(tmp_path) != text


@needs_modes
def test_token_is_no_link(tmp_path: Path) -> None:
    target = tmp_path / "target"
    target.write_text("z" * 43)
    target.chmod(0o600)
    (tmp_path / "studio-token").symlink_to(target)
    assert token_file.token(tmp_path) != "z" * 43
    assert target.read_text() == "z" * 43


@needs_modes
def test_token_is_no_pipe(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "studio-token", 0o600)
    assert re.fullmatch(r"[\w-]{43}", token_file.token(tmp_path))


def test_token_that_cannot_be_kept(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(FileError, match="cannot be kept"):
        token_file.token(tmp_path / "file")


def test_state_folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    if sys.platform != "win32":
        monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
        assert token_file.state_folder() == tmp_path / "gcrules"
        monkeypatch.setenv("XDG_STATE_HOME", "relative")
        assert token_file.state_folder().is_relative_to(Path.home())

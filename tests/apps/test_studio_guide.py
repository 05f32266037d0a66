"""The guide beside the studio, where it has been built, and the addresses that the page has of it."""

from __future__ import annotations

import warnings
from pathlib import Path

import pytest
from places import ROOT

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

from apps.studio_client import KNOWN, OWN, PORT, TOKEN, Page

from gcrules.apps.studio import app
from gcrules.views.glossary import GLOSSARY


@pytest.fixture
def built(tmp_path: Path) -> Path:
    """A guide of two pages, and a file beside it that is no part of it."""
    site = tmp_path / "site"
    (site / "course").mkdir(parents=True)
    (site / "index.html").write_text("start")
    (site / "course" / "bracket.html").write_text("brackets")
    (tmp_path / "secret.html").write_text("secret")
    return site


@pytest.mark.parametrize("there", [False, True])
def test_the_guide_is_served_where_it_is_built(monkeypatch: pytest.MonkeyPatch, built: Path, there: bool) -> None:
    with warnings.catch_warnings():  # it says which client it will use one day
        warnings.simplefilter("ignore")
        from starlette.testclient import TestClient

    monkeypatch.setattr(app, "guide_folder", lambda: built if there else None)
    with TestClient(app.make_app(PORT, TOKEN), base_url=OWN) as client:
        with client.websocket_connect("/ws", headers=KNOWN) as socket:
            assert Page(socket).ask("hello")["guide"] is there
        assert client.get("/guide/index.html").status_code == 403, "it is for whom the token is known"
        client.headers.update(KNOWN)
        found = client.get("/guide/course/bracket.html")
        assert (found.status_code, found.text) == ((200, "brackets") if there else (404, "There is no such file.\n"))
        (built / "course" / "later.html").write_text("later")
        assert client.get("/guide/course/later.html").status_code == (200 if there else 404)
        (built / "link.html").symlink_to(built.parent / "secret.html")
        outside = ("../secret.html", "%2e%2e/secret.html", "..%2fsecret.html", "/etc/passwd", "link.html", "a%00.html")
        for name in (*outside, "none.html"):
            assert client.get(f"/guide/{name}").status_code == 404, name
        assert "default-src 'self'" in found.headers["content-security-policy"]
        assert "wasm" in found.headers["content-security-policy"]
        assert "wasm" not in client.get("/").headers["content-security-policy"]


def test_every_term_names_a_page_of_the_guide() -> None:
    for entry in GLOSSARY:
        page, _, part = entry["page"].partition("#")
        text = (ROOT / "docs" / page).read_text(encoding="utf-8")
        words = [line.lstrip("# ").lower() for line in text.splitlines() if line.startswith("#")]
        assert not part or any(
            part == "-".join("".join(c for c in w if c.isalnum() or c in " -").split()) for w in words
        )

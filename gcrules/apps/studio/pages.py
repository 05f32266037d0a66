"""The files of the page: those of the bundle and no others, each with its type."""

from __future__ import annotations

import hashlib
from contextlib import suppress
from pathlib import Path

from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response

from gcrules.core.dataclass import dataclass
from gcrules.views.viewer import FOLDER

__all__ = ["STATIC", "Pages", "guide_folder"]

STATIC = (Path(__file__).parent / "static", FOLDER)
"""The page, and the viewer that it shares with reports and notebooks."""


def guide_folder() -> Path | None:
    """The guide that `make docs` has built beside the package, in a checkout of the sources; None where there is none:
    what is installed from a package comes without it.
    """
    root = Path(__file__).resolve().parents[3]
    built = root / "build" / "site"
    return built if (root / "mkdocs.yml").is_file() and (built / "index.html").is_file() else None


_TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".mjs": "text/javascript; charset=utf-8",
    ".wasm": "application/wasm",
    ".zip": "application/zip",
    ".css": "text/css; charset=utf-8",
    ".woff2": "font/woff2",
    ".svg": "image/svg+xml",
    ".txt": "text/plain; charset=utf-8",
    ".png": "image/png",
    ".woff": "font/woff",
    ".ttf": "font/ttf",
    ".json": "application/json",
}
_KEPT = {".woff2": "max-age=604800"}
"""How long a browser keeps a file without asking; for others it asks each time whether they have changed."""

_NOT_BUILT = "The page is not part of this installation; build it with `npm run build` in studio-ui.\n"


@dataclass(frozen=True)
class _File:
    data: bytes
    tag: str
    changed: int


class Pages:
    """Serves the files of some folders, read when they are first asked for or have changed; of one name, the first."""

    def __init__(self, *folders: Path) -> None:
        self.folders = folders or STATIC
        self.known: dict[Path, _File] = {}

    async def answer(self, request: Request) -> Response:
        """The file that is asked for."""
        name = request.path_params.get("name", "") or "index.html"
        path = self._path(name)
        if path is None:
            missing = _NOT_BUILT if name == "index.html" else "There is no such file.\n"
            return PlainTextResponse(missing, 404)
        file = self._file(path)
        headers = {"etag": file.tag, "cache-control": _KEPT.get(path.suffix, "no-cache")}
        if request.headers.get("if-none-match") == file.tag:
            return Response(status_code=304, headers=headers)
        return Response(file.data, media_type=_TYPES[path.suffix], headers=headers)

    def _path(self, name: str) -> Path | None:
        """The file of this name, of the first folder that has one; nothing that lies outside them is one."""
        for folder in self.folders:
            with suppress(OSError, ValueError):  # names that no file can have
                path, home = (folder / name).resolve(), folder.resolve()
                if path.is_relative_to(home) and path.suffix in _TYPES and path.is_file():
                    return path
        return None

    def _file(self, path: Path) -> _File:
        changed = path.stat().st_mtime_ns
        known = self.known.get(path)
        if known is None or known.changed != changed:
            data = path.read_bytes()
            known = self.known[path] = _File(data, f'"{hashlib.sha256(data).hexdigest()[:32]}"', changed)
        return known

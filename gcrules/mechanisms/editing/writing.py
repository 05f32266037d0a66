"""A sheet as the text of a robot file. What a change leaves alone stays as it was written, comments included."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from gcrules.core.yaml_text import quoted
from gcrules.mechanisms.editing.reading import PlacedSheet
from gcrules.mechanisms.editing.sheet import LimbRow, Sheet

__all__ = ["rewritten", "sheet_text"]

_ORDER = (
    "title", "source", "note", "units", "space", "copies", "points", "directions", "limbs", "platform", "facts",
    "mobility", "limits", "condition", "home", "drawing",
)  # fmt: skip
_PLAIN = re.compile(r"[A-Za-z0-9][\w %'+*/,.()=:-]*")
_COMMENT = re.compile(r"\s+#.*$")


def sheet_text(sheet: Sheet) -> str:
    """The whole file, written anew."""
    return "".join(f"{line}\n" for lines in _sections(sheet).values() for line in lines)


def rewritten(text: str, before: PlacedSheet, after: Sheet) -> str:
    """The text of a file, which reads as the sheet `before`, changed so that it reads as the sheet `after`."""
    new = _sections(after)
    if not before.keys:
        return sheet_text(after)
    old = _sections(before.sheet)
    written = dict(_written(text, before.keys))
    found = [*written.pop("", [])]
    rest = [key for key in new if key not in written]
    for key, (prelude, lines) in _split(written).items():
        for other in [k for k in rest if _place(k) < _place(key)]:
            found += new[other]
            rest.remove(other)
        if key in new:
            found += [*prelude, *(lines if old.get(key) == new[key] else _merged(lines, new[key]))]
    for other in rest:
        found += new[other]
    return "".join(f"{line}\n" for line in found)


def _place(key: str) -> int:
    return _ORDER.index(key) if key in _ORDER else len(_ORDER)


def _written(text: str, keys: Mapping[str, int]) -> Iterator[tuple[str, list[str]]]:
    """The lines of each key of the file, and under "" those before the first."""
    starts = [(text.rfind("\n", 0, at) + 1, key) for key, at in keys.items()]
    yield "", text[: starts[0][0]].splitlines() if starts else []
    for (start, key), end in zip(starts, [*(s for s, _ in starts[1:]), len(text)], strict=True):
        yield key, text[start:end].splitlines()


def _split(written: Mapping[str, list[str]]) -> dict[str, tuple[list[str], list[str]]]:
    """For each key the comments and empty lines before it, and its own lines."""
    found: dict[str, tuple[list[str], list[str]]] = {}
    prelude: list[str] = []
    for key, lines in written.items():
        own = list(lines)
        after: list[str] = []
        while len(own) > 1 and (not own[-1].strip() or own[-1].startswith("#")):
            after.insert(0, own.pop())
        found[key] = prelude, own
        prelude = after
    return found


def _merged(old: Sequence[str], new: Sequence[str]) -> list[str]:
    """New lines of a key; those that were there keep the comments behind and before them."""
    kept: dict[str, list[str]] = {}
    comments: list[str] = []
    for line in old:
        if line.lstrip().startswith("#"):
            comments.append(line)
            continue
        kept.setdefault(line if '"' in line else _COMMENT.sub("", line.rstrip()), [*comments, line])
        comments = []
    return [line for own in new for line in kept.pop(own, [own])]


# --- sections ------------------------------------------------------------------------------------------------------


def _sections(sheet: Sheet) -> dict[str, list[str]]:
    """The lines of each key, in their usual sequence; keys without content are left out."""
    found = {key: [_other(key, value)] for key, value in sheet.others.items()}
    found["title"] = [f"title: {quoted(sheet.title)}"]
    if sheet.plane:
        found["space"] = ["space: plane"]
    if sheet.copies:
        found["copies"] = [f"copies: {sheet.copies}"]
    for sort in ("point", "direction"):
        rows = [f"  {row.name}: {_plain(row.relation)}" for row in sheet.names if row.sort == sort]
        found[f"{sort}s"] = [f"{sort}s:", *rows] if rows else ["points: {}"] if sort == "point" else []
    rows = [line for limb in sheet.limbs for line in _limb(limb)]
    found["limbs"] = ["limbs:", *rows] if rows else ["limbs: []"]
    if sheet.platform:
        found["platform"] = [f"platform: {_plain(sheet.platform)}"]
    found["mobility"] = [f"mobility: {sheet.mobility or 0}"]
    for key, places in (("home", sheet.home), ("drawing", sheet.drawing)):
        if places:
            found[key] = [f"{key}:", *(f"  {n}: [{', '.join(c for c in at if c)}]" for n, at in places.items())]
    return {key: found[key] for key in sorted(found, key=_place) if found[key]}


def _other(key: str, value: str | tuple[str, ...]) -> str:
    return f"{key}: {quoted(value)}" if isinstance(value, str) else f"{key}: [{', '.join(map(quoted, value))}]"


def _plain(text: str) -> str:
    return text if _PLAIN.fullmatch(text) and ": " not in text and text == text.strip() else quoted(text)


def _limb(limb: LimbRow) -> Iterator[str]:
    yield f"  - name: {_plain(limb.name)}"
    if limb.cable:
        yield f"    cable: {_plain(limb.cable)}"
    elif len(limb.chains) == 1 and not limb.chains[0].head:
        yield f"    joints: {_plain(limb.chains[0].text)}"
    else:
        yield "    joints:"
        yield from (f"      - {chain.head}: {_plain(chain.text)}" for chain in limb.chains)
    for key in ("through", "couplings"):
        if value := getattr(limb, key):
            yield f"    {key}: {_plain(value)}"

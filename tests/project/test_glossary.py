"""The glossary: one table for the guide and for the studio."""

from __future__ import annotations

import re

import pytest
from places import ROOT, tool

from gcrules.views.glossary import GLOSSARY, anchor, markdown

site_glossary = tool("site_glossary")


def test_the_page_of_the_guide_is_that_of_the_table() -> None:
    """`python tools/check_docs.py --write` writes it; that its links lead somewhere is checked there."""
    assert (ROOT / "docs" / "glossary.md").read_text(encoding="utf-8") == markdown()


def test_terms_stand_in_order_and_no_word_means_two_things() -> None:
    terms = [e["term"] for e in GLOSSARY]
    assert terms == sorted(terms, key=str.lower)
    words = [w.lower() for e in GLOSSARY for w in [e["term"], *filter(None, e["forms"].split("|"))]]
    assert len(words) == len(set(words))
    assert all(e["meaning"].endswith(".") for e in GLOSSARY)


@pytest.mark.parametrize(
    "term",
    [
        "reading",
        "family",
        "member",
        "idle freedom",
        "cofactor",
        "codimension",
        "group of conditions",
        "line variety",
        "standard tableau",
        "replayed",
        "softest motion",
    ],
)
def test_pages_link_a_term_where_they_first_use_it(term: str) -> None:
    (entry,) = (e for e in GLOSSARY if e["term"] == term)
    names = "|".join(map(re.escape, [term, *filter(None, entry["forms"].split("|"))]))
    used = []
    for path in (ROOT / "docs").rglob("*.md"):
        page = path.relative_to(ROOT / "docs").as_posix()
        if page == site_glossary.PAGE or page.startswith("assets/"):
            continue
        text = path.read_text(encoding="utf-8")
        prose = text
        for pattern in site_glossary.OTHER:
            prose = pattern.sub("", prose)
        if re.search(rf"(?<![\w-])(?:{names})(?![\w-])", prose, re.IGNORECASE):
            used.append(page)
            assert site_glossary.link(text, page).count(f'glossary.md#{anchor(term)} "') == 1, page
    assert used

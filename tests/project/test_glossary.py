"""The glossary: one table for the guide and for the studio."""

from __future__ import annotations

from places import ROOT

from gcrules.views.glossary import GLOSSARY, markdown


def test_the_page_of_the_guide_is_that_of_the_table() -> None:
    """`python tools/check_docs.py --write` writes it; that its links lead somewhere is checked there."""
    assert (ROOT / "docs" / "glossary.md").read_text(encoding="utf-8") == markdown()


def test_terms_stand_in_order_and_no_word_means_two_things() -> None:
    terms = [e["term"] for e in GLOSSARY]
    assert terms == sorted(terms, key=str.lower)
    words = [w.lower() for e in GLOSSARY for w in [e["term"], *filter(None, e["forms"].split("|"))]]
    assert len(words) == len(set(words))
    assert all(e["meaning"].endswith(".") for e in GLOSSARY)

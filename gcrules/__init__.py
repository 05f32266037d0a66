r"""gcrules: when, and why, is a parallel robot singular? Grassmann–Cayley algebra with proofs.

    >>> import gcrules as gc
    >>> print(gc.expand(r"ab /\ cde"))
    [acde] * b - [bcde] * a
    >>> gc.prove(r"ab /\ cd == [abcd]").verdict
    'proved'

The names below load what they need when they are first used.
"""

from __future__ import annotations

from importlib import import_module

from gcrules.core.shown import show_by
from gcrules.core.version import __version__

show_by("gcrules.views.forms:shown")

TYPE_CHECKING = False  # the command line begins here, and hears no signals while typing is loaded
if TYPE_CHECKING:
    from typing import Any

    from gcrules.api.discovery import Discoveries, discover
    from gcrules.api.factors import Factors, factors
    from gcrules.api.functions import (
        Analysis,
        BracketPolynomial,
        Condition,
        Expr,
        ExtensorPolynomial,
        Factorization,
        GcrulesError,
        InputError,
        Library,
        LimitReached,
        Platform,
        Plugin,
        Proof,
        Robot,
        RobotAnalysis,
        Shortening,
        StepError,
        Strategy,
        Structure,
        SyntaxFault,
        Transversals,
        analyze,
        evaluate,
        expand,
        factor,
        load,
        load_rules,
        paper,
        parse,
        prove,
        report,
        seeded,
        shorten,
        shortest,
        straighten,
        superbracket,
        transversals,
        within,
    )
    from gcrules.api.poses import (
        aspects,
        assembly_modes,
        box_map,
        certify,
        compiled,
        export,
        export_model,
        free_region,
        length_regions,
        locus,
        map_status,
        merge_maps,
        operation_modes,
        path,
        plan,
        pose,
        refine_map,
        singular,
        singular_map,
        verify_map,
        working_modes,
    )
    from gcrules.api.proofs import ProofFile, proof_file
    from gcrules.api.rewriting import Rewriting, rewrite
    from gcrules.apps.notebook.studio import studio
    from gcrules.apps.notebook.view import view

__all__ = [
    "Analysis",
    "BracketPolynomial",
    "Condition",
    "Discoveries",
    "Expr",
    "ExtensorPolynomial",
    "Factorization",
    "Factors",
    "GcrulesError",
    "InputError",
    "Library",
    "LimitReached",
    "Platform",
    "Plugin",
    "Proof",
    "ProofFile",
    "Rewriting",
    "Robot",
    "RobotAnalysis",
    "Shortening",
    "StepError",
    "Strategy",
    "Structure",
    "SyntaxFault",
    "Transversals",
    "__version__",
    "analyze",
    "aspects",
    "assembly_modes",
    "box_map",
    "certify",
    "compiled",
    "discover",
    "evaluate",
    "expand",
    "export",
    "export_model",
    "factor",
    "factors",
    "free_region",
    "length_regions",
    "load",
    "load_rules",
    "locus",
    "map_status",
    "merge_maps",
    "operation_modes",
    "paper",
    "parse",
    "path",
    "plan",
    "pose",
    "proof_file",
    "prove",
    "refine_map",
    "report",
    "rewrite",
    "seeded",
    "shorten",
    "shortest",
    "singular",
    "singular_map",
    "straighten",
    "studio",
    "superbracket",
    "transversals",
    "verify_map",
    "view",
    "within",
    "working_modes",
]


_ELSEWHERE = {
    **dict.fromkeys(
        (
            "aspects",
            "assembly_modes",
            "box_map",
            "certify",
            "compiled",
            "export",
            "export_model",
            "free_region",
            "length_regions",
            "locus",
            "map_status",
            "merge_maps",
            "operation_modes",
            "path",
            "plan",
            "pose",
            "refine_map",
            "singular",
            "singular_map",
            "verify_map",
            "working_modes",
        ),
        "gcrules.api.poses",
    ),
    **dict.fromkeys(("Discoveries", "discover"), "gcrules.api.discovery"),
    **dict.fromkeys(("Factors", "factors"), "gcrules.api.factors"),
    **dict.fromkeys(("ProofFile", "proof_file"), "gcrules.api.proofs"),
    **dict.fromkeys(("Rewriting", "rewrite"), "gcrules.api.rewriting"),
    "studio": "gcrules.apps.notebook.studio",
    "view": "gcrules.apps.notebook.view",  # these two show a robot in an app
}


_OF_COMMANDS = {
    "free": "free_region",
    "map": "singular_map",
    "modes": "assembly_modes",
    "regions": "length_regions",
}
"""Functions that are called otherwise than the commands that answer the same."""


def __getattr__(name: str) -> Any:
    if name in __all__:
        return getattr(import_module(_ELSEWHERE.get(name, "gcrules.api.functions")), name)
    meant = _OF_COMMANDS.get(name)
    hint = f"; the command `gcrules {name}` is gcrules.{meant} in Python" if meant else ""
    raise AttributeError(f"module 'gcrules' has no attribute {name!r}{hint}", name=name)


def __dir__() -> list[str]:
    return sorted(__all__)

"""Everything that a page can ask for: arguments, answer, where it is worked out, and for how long.

What answers it stands in `gcrules.apps.studio.answers`.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Any, Literal

from gcrules.apps.studio.protocol import answer_views as answers
from gcrules.apps.studio.protocol import requests
from gcrules.apps.studio.protocol.checking import Check
from gcrules.apps.studio.protocol.limb_requests import LimbsArgs
from gcrules.apps.studio.protocol.limb_views import LimbsAnswer
from gcrules.apps.studio.protocol.locus_views import LocusAnswer
from gcrules.apps.studio.protocol.motion_views import (
    HereAnswer,
    MapAnswer,
    PathAnswer,
    PlacedPose,
    SurfaceAnswer,
    WaypointsAnswer,
)
from gcrules.apps.studio.protocol.report_requests import CertificateFileArgs, RepeatArgs, SaveArgs
from gcrules.apps.studio.protocol.rule_views import CheckedRules, PluginsAnswer
from gcrules.apps.studio.protocol.shape_checks import check_of
from gcrules.apps.studio.protocol.study_views import Gallery, Hello, Study
from gcrules.apps.studio.protocol.where_views import (
    AspectsAnswer,
    AssembliesAnswer,
    BoxesAnswer,
    CertificateAnswer,
    CertificateFile,
    FreeAnswer,
)
from gcrules.core.dataclass import dataclass

__all__ = ["LONGEST", "METHODS", "Method"]

LONGEST = 1_000_000
"""Characters of a message; files are sent in one."""


@dataclass(frozen=True)
class Method:
    """`args`, `answer` and `part`, of which some may come before the answer, are typed dictionaries. It works in the
    `session` with the page, in the server itself, in turn (`numbers`), or in a `worker` process, which is ended after
    so many `seconds`, and when the page gives up. With `folders` it is told the folders of plugins that the studio was
    started with, which no page can name.
    """

    args: Any
    answer: Any
    where: Literal["session", "numbers", "worker"] = "worker"
    seconds: float = 60.0
    folders: bool = False
    part: Any = None

    @cached_property
    def check(self) -> Check:
        """What reads the arguments, and raises InputError for others."""
        return check_of(self.args)


METHODS: Mapping[str, Method] = {
    "hello": Method(requests.NoArgs, Hello, where="session"),
    "gallery": Method(requests.NoArgs, Gallery),
    "open": Method(requests.OpenArgs, Study, seconds=120),
    "pose": Method(requests.PoseArgs, answers.Numbers, where="numbers", part=answers.Headline),
    "move": Method(requests.MoveArgs, PlacedPose, where="numbers"),
    "along": Method(requests.AlongArgs, answers.Along),
    "nearest": Method(requests.PoseArgs, answers.Nearest, seconds=120),
    "modes": Method(requests.ModesArgs, answers.ModesAnswer, seconds=120),
    "path": Method(requests.PathArgs, PathAnswer, seconds=300),
    "waypoints": Method(requests.WaypointsArgs, WaypointsAnswer),
    "map": Method(requests.MapArgs, MapAnswer, seconds=600),
    "surface": Method(requests.SurfaceArgs, SurfaceAnswer, seconds=600),
    "place": Method(requests.PlaceArgs, PlacedPose),
    "here": Method(requests.HereArgs, HereAnswer),
    "locus": Method(requests.LocusArgs, LocusAnswer, seconds=300),
    "assemblies": Method(requests.PoseArgs, AssembliesAnswer, seconds=300),
    "aspects": Method(requests.OpenArgs, AspectsAnswer, seconds=600),
    "free": Method(requests.FreeArgs, FreeAnswer, seconds=300),
    "boxes": Method(requests.BoxesArgs, BoxesAnswer, seconds=600),
    "certify": Method(requests.CertifyArgs, CertificateAnswer, seconds=600),
    "certificate": Method(CertificateFileArgs, CertificateFile, seconds=600),
    "manual": Method(requests.ManualArgs, answers.Manual),
    "bench": Method(requests.BenchArgs, answers.Bench, seconds=60, folders=True, part=answers.BenchPart),
    "rules": Method(requests.RulesArgs, CheckedRules, seconds=60),
    "plugins": Method(requests.NoArgs, PluginsAnswer, seconds=120, folders=True),
    "complete": Method(requests.CompleteArgs, answers.Completed, seconds=5),
    "script": Method(requests.ScriptArgs, answers.Scripted, seconds=10),
    "compose": Method(requests.ComposeArgs, answers.Composed),
    "resize": Method(requests.ResizeArgs, answers.Resized),
    "limbs": Method(LimbsArgs, LimbsAnswer),
    "save": Method(SaveArgs, answers.Saved, seconds=600, folders=True),
    "repeat": Method(RepeatArgs, answers.Repeated, folders=True),
    "follow": Method(requests.FollowArgs, answers.Followed, where="session"),
    "show": Method(requests.ShowArgs, answers.Shown, where="session"),
    "cancel": Method(requests.CancelArgs, answers.Cancelled, where="session"),
}

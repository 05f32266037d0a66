"""A studio that Python has opened: its page and Python move the same robot."""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping
from html import escape
from typing import Any

from gcrules.apps.studio.moving import amounts_at, posed
from gcrules.apps.studio.numbers import exact_pose
from gcrules.apps.studio.protocol.requests import HOME, PoseJson, SourceJson
from gcrules.apps.studio.serving import Background
from gcrules.apps.studio.shared_pose import SharedPose
from gcrules.apps.studio.subject import Subject, read_subject
from gcrules.apps.studio.whereabouts import coordinates_at, led, pose_json
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.coordinates import coordinates
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.solve import free_coordinates
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.pose_report import solution_at
from gcrules.poses.limbs.report import RobotPose
from gcrules.poses.numbers.pose_arguments import read_one
from gcrules.poses.numbers.report import PoseReport
from gcrules.poses.pose import pose as report_at
from gcrules.screws.pose import Pose

__all__ = ["StudioWindow"]

Place = Pose | Mapping[str, float]


class StudioWindow:
    """A studio beside Python, until it is closed or Python ends: a page moves the robot, and so does Python.

    `pose` is where it is: read, it is what the page shows; set, it moves the page. It is a `Pose` of a platform on six
    legs, and the free coordinates of a robot described by its joints (lengths, radians, from home); it may be set in
    all forms that `gcrules.pose` takes. `actuators` are those of a robot described by its joints, read and set
    likewise. As a context manager it is closed at the end of the block.
    """

    def __init__(self, opened: SourceJson, pose: Any = None, *, browser: bool = True) -> None:
        self._subject = read_subject(opened)
        limbs = self._subject.limbs
        count = len(leading(limbs.linkage)) if limbs else 0
        self._shared = SharedPose(HOME if pose is None else _pose_json(self._subject, pose), count)
        self._seen = 1
        self._studio = Background(opened, self._shared, browser=browser)

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self._subject.title}: {self.address if self.running else 'closed'}>"

    def _repr_html_(self) -> str:
        """A link for a notebook, which lets this browser in once."""
        if not self.running:
            return f"<p>The studio of {escape(self._subject.title)} is closed.</p>"
        link = escape(self._studio.link())
        return f'<p><a href="{link}" target="_blank" rel="noopener">{escape(self._subject.title)} in the studio</a></p>'

    @property
    def running(self) -> bool:
        return self._studio.running

    @property
    def address(self) -> str:
        """Where the page is; a browser that has not been let in needs `link`."""
        return self._studio.address

    def link(self) -> str:
        """An address that lets one browser in, once."""
        return self._studio.link()

    @property
    def pose(self) -> Place:
        return _place(self._subject, self._shared.now.pose)

    @pose.setter
    def pose(self, at: Any) -> None:
        self._shared.show(_pose_json(self._subject, at))

    @property
    def actuators(self) -> dict[str, float]:
        """Amounts from home, angles in radians. Raises InputError for a platform on six legs."""
        limbs = _limbs(self._subject)
        names = [a.name for a in leading(limbs.linkage)]
        amounts = amounts_at(limbs, self._shared.now.pose) or [0.0] * len(names)
        return dict(zip(names, amounts, strict=True))

    @actuators.setter
    def actuators(self, amounts: Any) -> None:
        limbs = _limbs(self._subject)
        there = solution_at(limbs.linkage, actuators=amounts).configuration
        values = {a.name: there.joint_values[a.place][a.coordinate] for a in limbs.linkage.actuators}
        self._shared.show(posed(limbs, [values[a.name] for a in leading(limbs.linkage)]))

    def wait(self, seconds: float | None = None) -> Place | None:
        """Where a page has moved the robot since the last time that this was asked, as soon as it has; None where it
        does not within so many seconds.
        """
        found = self._shared.wait(self._seen, seconds)
        if found is None:
            return None
        self._seen = found.version
        return _place(self._subject, found.pose)

    def observe(self, moved: Callable[[Place], object]) -> None:
        """Call a function with each pose to which a page moves the robot (the latest one, where they come faster than
        it answers), in a thread beside Python's own.
        """

        def listen() -> None:
            seen = self._shared.now.version
            while self.running:
                found = self._shared.wait(seen, 1.0)
                if found is not None:
                    seen = found.version
                    moved(_place(self._subject, found.pose))

        threading.Thread(target=listen, name="gcrules-studio-observer", daemon=True).start()

    def numbers(self, **options: Any) -> PoseReport | RobotPose:
        """The report of `gcrules.pose` where the robot is, with its options. Raises InputError where legs alone have
        been opened.
        """
        subject = self._subject
        if subject.invented:
            raise InputError("these legs have a sample shape, whose numbers mean nothing", hint="give a geometry file")
        if subject.limbs:
            found = report_at(subject.limbs.analysis, actuators=self.actuators, **options)
        else:
            assert subject.legs is not None
            found = report_at(subject.legs.platform, self.pose, about=subject.about, **options)
        assert isinstance(found, (PoseReport, RobotPose))
        return found

    def close(self) -> None:
        """End it; its pages say that the line is lost."""
        self._studio.close()

    def __enter__(self) -> StudioWindow:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def _limbs(subject: Subject) -> Limbs:
    if subject.limbs is None:
        raise InputError("a platform on six legs moves by its pose", hint="set `pose`")
    return subject.limbs


def _place(subject: Subject, pose: PoseJson) -> Place:
    if subject.limbs is None:
        return exact_pose(pose)
    return coordinates_at(subject.limbs, pose, free_coordinates(subject.limbs.linkage))


def _pose_json(subject: Subject, at: Any) -> PoseJson:
    """The pose of the page where `gcrules.pose` would have it. Raises InputError."""
    limbs = subject.limbs
    if limbs is None:
        return pose_json(read_one(at, subject.unit))
    m = limbs.linkage
    there = solution_at(m, at).configuration
    names = free_coordinates(m)
    return led(limbs, there, names, coordinates(names, there.platform, m.centre).tolist())

"""A run of a sketch in a window: its loop, its clock, and when its next frame is due."""

from __future__ import annotations

from dataclasses import dataclass

from sketchkit.core.clock import RealClock, VirtualClock
from sketchkit.runtime.inputs import Inputs
from sketchkit.runtime.loop import Loop
from sketchkit.runtime.pacing import Pacer


@dataclass
class Run:
    """A sketch from its beginning to its end, or to the next fresh start.

    Attributes
    ----------
    loop : Loop
    clock : RealClock or VirtualClock
        What the sketch reads.
    pacer : Pacer
    frame : int
        The one that was taken last; after `noLoop()` it goes on.
    """

    loop: Loop
    clock: RealClock | VirtualClock
    pacer: Pacer
    frame: int = 0

    def step(self, inputs: Inputs) -> bool:
        """Take the next frame with what happens in it; tell whether there is a new picture."""
        self.frame += 1
        if isinstance(self.clock, VirtualClock):
            self.clock.frame = self.frame
        for event in inputs.at(self.frame):
            self.loop.post(event)
        return self.loop.step()

    def pass_time(self, speed: float) -> None:
        """Let the sketch's time pass so fast from now on; a virtual clock follows the frames."""
        if isinstance(self.clock, RealClock):
            self.clock.run_at(speed)

    def skip_time(self, seconds: float) -> None:
        """Let some of the sketch's time pass at once."""
        if isinstance(self.clock, RealClock):
            self.clock.skip(seconds)

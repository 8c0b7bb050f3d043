"""When `draw()` is called, how often, and until when."""

from __future__ import annotations

import threading
from collections.abc import Callable

from sketchkit.api._sketch_parts import SketchParts
from sketchkit.api.live import LiveFloat, live
from sketchkit.core.clock import VirtualClock
from sketchkit.core.errors import SketchError, nearest, shown, wrong_numbers
from sketchkit.core.notices import warn_once


class Looping(SketchParts):
    """`loop()`, `noLoop()`, `frameRate()`, `exit()` and the like."""

    @property
    @live
    def frameCount(self) -> int:
        """How often `draw()` has been called: 0 in `setup()`, 1 in the first `draw()`.

        Examples
        --------
        >>> rotate(frameCount * 0.01)
        """
        return self.progress.frame_count

    @property
    @live
    def frameRate(self) -> LiveFloat:
        """How many frames are drawn in a second; as a function, how many there shall be.

        `frameRate(30)` asks for 30. Without it there are 60. `sketchkit render` draws as fast as it
        can, and says 60.

        Examples
        --------
        >>> frameRate(30)
        >>> println(frameRate)
        """
        return LiveFloat(self.progress.measured_rate, self._set_frame_rate)

    def loop(self) -> None:
        """Call `draw()` again and again, as it is at the beginning.

        See Also
        --------
        noLoop, redraw, isLooping

        Examples
        --------
        >>> loop()
        """
        self.progress.is_looping = True

    def noLoop(self) -> None:
        """Do not call `draw()` again by itself. In `setup()`: call it once.

        See Also
        --------
        loop, redraw, isLooping

        Examples
        --------
        >>> noLoop()
        """
        self.progress.is_looping = False

    def isLooping(self) -> bool:
        """Return whether `draw()` is called again and again.

        Examples
        --------
        >>> println(isLooping())
        """
        return self.progress.is_looping

    def redraw(self) -> None:
        """Call `draw()` once more, after `noLoop()`.

        See Also
        --------
        loop, noLoop

        Examples
        --------
        >>> redraw()
        """
        self.progress.is_redraw_due = True

    def exit(self) -> None:
        """End the sketch, when the running function has come to its end.

        Examples
        --------
        >>> exit()
        """
        self.progress.is_finished = True

    def delay(self, napTime: float) -> None:
        """Wait. Nothing is drawn and no key is heard in that time: `frameRate()` is mostly better.

        Parameters
        ----------
        napTime : float, milliseconds
            How long. `sketchkit render` does not wait: only `millis()` is later by so much.

        See Also
        --------
        millis, frameRate, thread

        Examples
        --------
        >>> delay(500)
        >>> millis() >= 500
        True
        """
        try:
            milliseconds = float(napTime)
        except (TypeError, ValueError):
            raise wrong_numbers("delay", (napTime,), "napTime") from None
        if not self._turns.wait(milliseconds):
            self._clock.wait(milliseconds)

    def thread(self, name: str | Callable[[], object]) -> None:
        """Run one of the sketch's functions beside the others, say to load something slowly.

        Parameters
        ----------
        name : str or function
            The function, or its name. It takes no arguments, and must not draw.

        Raises
        ------
        SketchError
            If there is no such function.

        See Also
        --------
        delay, requestImage

        Notes
        -----
        In `sketchkit render` it runs at once, until it ends or calls `delay()`, and goes on in the
        frame in which that time is over: so every run gives the same pictures.

        Examples
        --------
        >>> def loadEverything():
        ...     loadStrings("poem.txt")
        >>> thread("loadEverything")
        """
        function = self._function("thread", name)
        if not isinstance(self._clock, VirtualClock):
            threading.Thread(target=self._run_beside, args=(function,), daemon=True).start()
        elif not self._turns.start(lambda: self._run_beside(function)):
            warn_once(
                "The function of thread() has not come to its end: from here on pictures may "
                "differ from run to run. delay() in its loop lets the others go on."
            )

    def method(self, name: str) -> None:
        """Call one of the sketch's functions by its name.

        Raises
        ------
        SketchError
            If there is no such function.

        Examples
        --------
        >>> def drawTree():
        ...     line(50, 90, 50, 40)
        ...     circle(50, 30, 40)
        >>> method("drawTree")
        """
        self._function("method", name)()

    def _function(self, caller: str, name: str | Callable[[], object]) -> Callable[[], object]:
        function = self.namespace.get(name) if isinstance(name, str) else name
        if callable(function):
            return function
        functions = [own for own, value in self.namespace.items() if callable(value)]
        known = nearest(str(name), functions)
        raise SketchError(
            f"{caller}() takes one of your functions, or its name.",
            got=f"{caller}({shown(name)})",
            hint=f"Do you mean {known}?" if known else None,
        )

    def _run_beside(self, function: Callable[[], object]) -> None:
        try:
            function()
        except Exception as failure:
            self.progress.failures.append(failure)

    def go_on_beside(self) -> None:
        """Let functions that `thread()` has started go on, whose `delay()` is over."""
        self._turns.go_on()

    def end_beside(self) -> None:
        """End functions that `thread()` has started and that still wait."""
        self._turns.end()

    def _set_frame_rate(self, fps: float) -> None:
        try:
            wanted = float(fps)
        except (TypeError, ValueError):
            raise wrong_numbers("frameRate", (fps,), "fps") from None
        if not wanted > 0:
            raise SketchError(
                "frameRate() takes a number above 0.",
                got=f"frameRate({shown(fps)})",
                hint="noLoop() stops the animation.",
            )
        self.progress.wanted_rate = wanted

"""Date and time, from the sketch's clock: the computer's, or a fixed one in a render."""

from __future__ import annotations

from sketchkit.core.clock import Clock


class Dates:
    """What the clock says."""

    _clock: Clock

    def millis(self) -> int:
        """Return the milliseconds since the sketch began.

        Returns
        -------
        int
            Milliseconds, thousandths of a second. Frame 1 of a render is at 0, frame 2 at 17.

        See Also
        --------
        second, frameCount

        Examples
        --------
        >>> millis() >= 0
        True
        """
        return self._clock.millis()

    def second(self) -> int:
        """Return the seconds of the time of day.

        Returns
        -------
        int
            0 to 59.

        See Also
        --------
        minute, hour, millis

        Examples
        --------
        >>> 0 <= second() <= 59
        True
        """
        return self._clock.now().second

    def minute(self) -> int:
        """Return the minutes of the time of day.

        Returns
        -------
        int
            0 to 59.

        See Also
        --------
        second, hour

        Examples
        --------
        >>> 0 <= minute() <= 59
        True
        """
        return self._clock.now().minute

    def hour(self) -> int:
        """Return the hour of the time of day.

        Returns
        -------
        int
            0 to 23.

        See Also
        --------
        minute, second

        Examples
        --------
        >>> 0 <= hour() <= 23
        True
        """
        return self._clock.now().hour

    def day(self) -> int:
        """Return the day of the month.

        Returns
        -------
        int
            1 to 31.

        See Also
        --------
        month, year

        Examples
        --------
        >>> 1 <= day() <= 31
        True
        """
        return self._clock.now().day

    def month(self) -> int:
        """Return the month of the year.

        Returns
        -------
        int
            1 to 12.

        See Also
        --------
        day, year

        Examples
        --------
        >>> 1 <= month() <= 12
        True
        """
        return self._clock.now().month

    def year(self) -> int:
        """Return the year.

        Returns
        -------
        int
            Four digits.

        See Also
        --------
        day, month

        Examples
        --------
        >>> year() >= 2000
        True
        """
        return self._clock.now().year

"""MP4, by PyAV: H.264 in the pixel format that every browser and telephone plays."""

from __future__ import annotations

from fractions import Fraction
from typing import BinaryIO, Final

import numpy as np

from sketchkit.assets.movies.encoder import U8, MovieError
from sketchkit.assets.movies.mp4_index import bring_index_to_front

CODEC: Final = "libx264"
# crf: how much is lost; 23 is usual, 18 is hard to tell from the original.
OPTIONS = {"crf": "17", "preset": "medium"}
BT709 = 1  # the colours of HD television, which players assume


class Mp4Encoder:
    """Writes an MP4 with one H.264 stream."""

    def __init__(self, file: BinaryIO, size: tuple[int, int], fps: float) -> None:
        try:
            import av
        except ImportError:
            raise MovieError(
                "MP4 films need the package av.",
                hint="pip install 'sketchkit[video]' brings it; .gif, .webp and .png work without.",
            ) from None
        self._av, self._file = av, file
        if CODEC not in av.codecs_available:
            raise MovieError(
                f"The package av here cannot write H.264: it has no {CODEC}.",
                hint="pip install --force-reinstall av brings one that can.",
            )
        width, height = size
        self._container = av.open(file, "w", format="mp4")
        rate = Fraction(fps).limit_denominator(1001)
        stream = self._container.add_stream(CODEC, rate=rate, options=OPTIONS)
        stream.width, stream.height = width + width % 2, height + height % 2
        stream.pix_fmt = "yuv420p"
        context = stream.codec_context
        context.colorspace = context.color_primaries = context.color_trc = BT709
        self._stream = stream

    def add(self, pixels: U8) -> None:
        """Take the next frame, (h, w, 3). An odd size is made even by repeating the last pixels."""
        height, width = pixels.shape[:2]
        even = np.pad(pixels, ((0, height % 2), (0, width % 2), (0, 0)), mode="edge")
        frame = self._av.VideoFrame.from_ndarray(even, format="rgb24")
        frame = frame.reformat(format="yuv420p", dst_colorspace="ITU709", dst_color_range="MPEG")
        frame.pts = None  # the stream counts
        self._container.mux(self._stream.encode(frame))

    def finish(self) -> str | None:
        """Write what is missing."""
        self._container.mux(self._stream.encode())
        self._container.close()
        bring_index_to_front(self._file)
        return None

    def close(self) -> None:
        """Let go of the encoder."""
        self._container.close()

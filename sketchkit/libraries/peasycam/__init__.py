"""PeasyCam: a camera that the mouse turns around what it looks at.

It does what Jonathan Feinberg's library of that name does for Processing, by the same numbers.
"""

from sketchkit.libraries.peasycam.camera import PeasyCam
from sketchkit.libraries.peasycam.handlers import PeasyDragHandler, PeasyWheelHandler
from sketchkit.libraries.peasycam.state import CameraState

__all__ = ["CameraState", "PeasyCam", "PeasyDragHandler", "PeasyWheelHandler"]

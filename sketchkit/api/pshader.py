"""PShader: a program for the graphics card, written in GLSL by the sketch."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from weakref import WeakSet

from sketchkit.api.pconstants import PConstants
from sketchkit.api.shader_files import ShaderPaths, read_source
from sketchkit.api.shader_values import numbers_for, textures_for
from sketchkit.core.errors import SketchError, kind_of, nearest, shown
from sketchkit.core.notices import calling_place, warn_once
from sketchkit.draw.backend import Backend
from sketchkit.draw.renderer import RecordsRows
from sketchkit.draw.resources import CubeMap, Target
from sketchkit.draw.shading import (
    PREVIOUS,
    ShaderFile,
    ShaderSource,
    Shading,
    Uniforms,
    UniformValue,
)
from sketchkit.glsl.interface import Declared

ELEMENT = re.compile(r"(.+)\[(\d+)\]$")
FILLED = {"resolution", "viewport", PREVIOUS}  # Processing fills these, whatever the sketch sets


class PShader(PConstants):
    """A shader: `loadShader()` makes one, `shader()` and `filter()` use it.

    Parameters
    ----------
    parent : object
        The sketch, `this`; it is not used.
    vertex, fragment : str or list of str
        The text of the two shaders, whole or line by line.

    Notes
    -----
    Processing's names for uniforms (`transform`, `modelview`, `texture`, `lightPosition`, ...) and
    attributes (`position`, `color`, `normal`, `texCoord`, ...) are filled by themselves. Source:
    Processing's reference, PShader; the course guide's section 4.10.

    Examples
    --------
    >>> size(100, 100, P2D)
    >>> vert = '''
    ... uniform mat4 transform;
    ... attribute vec4 position;
    ... void main() { gl_Position = transform * position; }'''
    >>> frag = '''
    ... uniform vec3 tone;
    ... void main() { gl_FragColor = vec4(tone, 1.0); }'''
    >>> orange = PShader(this, vert, frag)
    >>> orange.set("tone", 1.0, 0.6, 0.2)
    >>> shader(orange)
    >>> rect(20, 20, 60, 60)
    """

    def __init__(
        self, parent: object, vertex: str | Iterable[str], fragment: str | Iterable[str]
    ) -> None:
        source, declared = read_source(
            ShaderFile(_text(vertex), "the vertex shader"),
            ShaderFile(_text(fragment), "the fragment shader"),
        )
        self._begin(source, declared, None)

    @classmethod
    def _load(cls, files: ShaderPaths, backend: Backend) -> PShader:
        """Return a shader of what files hold.

        Raises
        ------
        SketchError
            If it does not compile.
        """
        source, declared = files.read()
        backend.prepare(source)
        shader = cls.__new__(cls)
        shader._begin(source, declared, files)
        _loaded.add(shader)
        return shader

    def _begin(
        self, source: ShaderSource, declared: Mapping[str, Declared], files: ShaderPaths | None
    ) -> None:
        self._source, self._declared, self._files = source, declared, files
        self._values: dict[str, UniformValue] = {}
        self._images: dict[str, tuple[object, ...]] = {}
        self._uniforms: Uniforms | None = None
        self._canvases: WeakSet[RecordsRows] = WeakSet()

    def _reload(self, backend: Backend) -> None:
        """Be what the files hold now; if that does not compile, stay as it is."""
        assert self._files is not None
        source, declared = self._files.read()
        backend.prepare(source)
        for name in [n for n in self._values if declared.get(n) != self._declared.get(n)]:
            del self._values[name]
            self._images.pop(name, None)
        self._source, self._declared = source, declared
        self._renew()

    def set(self, name: str, *values: object) -> None:
        """Give a uniform of the shader a value; it keeps it until it is set again.

        Parameters
        ----------
        name : str
            Of the uniform; also of a member, `"lamp.place"`, or an element, `"tones[2]"`.
        *values : float, int, bool, PVector, PMatrix, PImage, PGraphics, or lists of them
            As many numbers as it has parts, one by one or as a list. Numbers take the type that
            the shader declares. A list of images fills an array of samplers; six of them a cube
            map (right, left, bottom, top, front, back).

        Raises
        ------
        SketchError
            If the values do not fit what the shader declares.

        See Also
        --------
        shader, loadShader

        Notes
        -----
        What was drawn before keeps the value it was drawn with. A PMatrix arrives with its rows
        where GLSL has columns, as in Processing; nested lists and NumPy arrays arrive as they are
        written, so that `m * v` is what it is on paper; a flat list lies as GLSL stores it, column
        by column. Source: Processing's reference, PShader.set().

        Examples
        --------
        >>> size(100, 100, P2D)
        >>> wave = loadShader("wave.glsl")
        >>> wave.set("time", millis() / 1000.0)
        >>> wave.set("tone", 1.0, 0.6, 0.2)
        """
        declared = self._declared.get(name)
        if declared is None and (element := ELEMENT.match(name)):
            self._set_element(element[1], int(element[2]), values)
            return
        if declared is None:
            self._warn_unknown(name)
            return
        if name in FILLED:
            return
        if "sampler" in declared.type:
            value: UniformValue = textures_for(name, declared, values)
            self._images[name] = values
            for image in value if isinstance(value, tuple) else (value,):
                if isinstance(image, Target):
                    image.is_noted = True  # it may be drawn on with this very shader
        else:
            value = numbers_for(name, declared, values)
        self._values[name] = value
        self._renew()

    def _set_element(self, name: str, index: int, values: tuple[object, ...]) -> None:
        """Set one element of an array; the others keep theirs."""
        declared = self._declared.get(name)
        if declared is None or declared.length is None:
            self._warn_unknown(name)
            return
        if index >= declared.length:
            raise SketchError(
                f"{name} has {declared.length} elements in the shader.", got=f"{name}[{index}]"
            )
        if "sampler" in declared.type:
            raise SketchError("The images of an array are set all at once, as a list.")
        single = numbers_for(name, Declared(declared.type, None), values)
        size = len(single)
        held = self._values.get(name, (0.0,) * (size * declared.length))
        assert isinstance(held, tuple)
        parts = [*held[: index * size], *single, *held[(index + 1) * size :]]
        self._values[name] = tuple(parts)
        self._renew()

    def _warn_unknown(self, name: str) -> None:
        known = nearest(name, self._declared)
        hint = f" Do you mean {known!r}?" if known else ""
        warn_once(f"The shader of {self._source.name} has no uniform {name!r}.{hint}")

    def _renew(self) -> None:
        """Have what is drawn from now on use the new values."""
        self._uniforms = None
        for canvas in self._canvases:
            canvas.forget_state()

    def _shading(self) -> Shading:
        """Return the program with the values that it has now."""
        self._look_at_images()
        if self._uniforms is None:
            self._uniforms = Uniforms(dict(self._values), calling_place())
        return Shading(self._source, self._uniforms)

    @property
    def _follows_images(self) -> bool:
        """Whether its values may change without a word: images do, where pixels are set."""
        return bool(self._images)

    def _look_at_images(self) -> None:
        """Take over what has changed in the images that it was given."""
        for name, images in self._images.items():
            value = textures_for(name, self._declared[name], images)
            if _parts(value) != _parts(self._values[name]):
                self._values[name] = value
                self._uniforms = None

    def bind(self) -> None:
        """Do nothing: a shader is in force from `shader()` to `resetShader()`.

        Examples
        --------
        >>> size(100, 100, P2D)
        >>> wave = loadShader("wave.glsl")
        >>> wave.bind()
        """

    def unbind(self) -> None:
        """Do nothing: see `bind()`.

        Examples
        --------
        >>> size(100, 100, P2D)
        >>> wave = loadShader("wave.glsl")
        >>> wave.unbind()
        """

    def bound(self) -> bool:
        """Return whether the shader is in force on a canvas.

        Examples
        --------
        >>> size(100, 100, P2D)
        >>> wave = loadShader("wave.glsl")
        >>> print(wave.bound())
        False
        """
        return len(self._canvases) > 0

    def __repr__(self) -> str:
        return f"<PShader: {self._source.name}>"


def _parts(value: UniformValue) -> object:
    """Return what tells two values of samplers apart."""
    return value.faces if isinstance(value, CubeMap) else value


def _text(part: str | Iterable[str]) -> str:
    """Return a shader's text, given whole or as lines."""
    if isinstance(part, str):
        return part
    try:
        return "\n".join(str(line).rstrip("\n") for line in part)
    except TypeError:
        raise SketchError(
            "PShader() takes the text of a vertex and of a fragment shader.",
            got=f"{kind_of(part)}: {shown(part)}",
            hint="loadShader() reads them from files.",
        ) from None


_loaded: WeakSet[PShader] = WeakSet()


def loaded_files() -> set[Path]:
    """Return the files of all shaders that `loadShader()` has read and that are still there."""
    return {path for shader in _loaded if shader._files for path in shader._files.all}


def reload_shaders(changed: Iterable[Path], backend: Backend) -> bool:
    """Compile the shaders anew whose files have changed; return whether there are any.

    Raises
    ------
    SketchError
        If one does not compile: it stays what it was.
    """
    paths = set(changed)
    affected = [s for s in _loaded if s._files and paths & set(s._files.all)]
    for shader in affected:
        shader._reload(backend)
    return bool(affected)

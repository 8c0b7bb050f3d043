"""Write a page from a template of this folder, with everything that it needs inside.

Texts are escaped wherever they go: names and output of submissions are untrusted. A page allows
itself no script but its own (by hash) and no address outside of its folder.
"""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from importlib import resources

from sketchkit.assets.output import U8, picture_bytes
from sketchkit.core.errors import SketchError
from sketchkit.grading.texts import visible

FOLDER = "sketchkit.grading.pages"


@dataclass(frozen=True)
class Parts:
    """What a page is made of besides its template.

    Attributes
    ----------
    styles, scripts : tuple of str
        Files of this folder, in their order.
    pictures : str
        Where pictures may come from, as a Content-Security-Policy says it.
    """

    styles: tuple[str, ...] = ("style.css",)
    scripts: tuple[str, ...] = ("comparison.js",)
    pictures: str = "'self' file: data:"


PARTS = {
    "diff.html.j2": Parts(pictures="data:"),
    "student.html.j2": Parts(("style.css", "report.css", "student.css"), pictures="data:"),
    "class.html.j2": Parts(("style.css", "report.css", "class.css"), ("class.js",), "data:"),
}


def page(template: str, **values: object) -> str:
    """Return a page as text.

    Parameters
    ----------
    template : str
        A file of this folder: "diff.html.j2". It can use `style` and `script`, whole elements
        that belong in its head and at the end of its body, and `policy`, what its
        Content-Security-Policy says.
    **values
        What the template names.

    Raises
    ------
    SketchError
        If Jinja is not installed.
    """
    return _renderer(template)(**values)


def data_uri(pixels: U8) -> str:
    """Return a picture, (h, w, 3 or 4) uint8, as an address that holds all of it."""
    return f"data:image/png;base64,{base64.b64encode(picture_bytes(pixels, '.png')).decode()}"


@cache
def _renderer(template: str) -> Callable[..., str]:
    """Return what writes pages of a template."""
    try:
        from jinja2 import Environment, FunctionLoader, StrictUndefined
        from markupsafe import Markup
    except ImportError:
        raise SketchError(
            "Pages are written with Jinja, which is not installed.",
            hint='Write pip install "sketchkit[grade]".',
        ) from None
    environment = Environment(
        loader=FunctionLoader(_text),
        autoescape=True,
        finalize=lambda value: visible(value) if type(value) is str else value,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    parts = PARTS.get(template, Parts())
    style, script = _joined(parts.styles), _joined(parts.scripts)
    environment.globals.update(
        style=Markup(f"<style>{style}</style>"),  # ours, not a submission's
        script=Markup(f"<script>{script}</script>"),
        policy=(
            f"default-src 'none'; img-src {parts.pictures}; style-src {_hash(style)}; "
            f"script-src {_hash(script)}; base-uri 'none'; form-action 'none'"
        ),
    )
    return environment.get_template(template).render


def _text(name: str) -> str:
    return (resources.files(FOLDER) / name).read_text(encoding="utf-8")


def _joined(names: tuple[str, ...]) -> str:
    return "\n".join(_text(name) for name in names)


def _hash(text: str) -> str:
    """Return a text as a policy names it."""
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"

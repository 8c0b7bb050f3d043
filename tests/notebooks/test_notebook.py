"""A real notebook: a kernel of its own runs its cells one after the other."""

from __future__ import annotations

import base64
from io import BytesIO
from pathlib import Path

import pytest
from PIL import Image

nbformat = pytest.importorskip("nbformat")
nbclient = pytest.importorskip("nbclient")
pytest.importorskip("ipykernel")

ROOT = Path(__file__).parents[2]
CELLS = (
    "import sys; sys.path.insert(0, r'{root}')\nimport sketchkit\n%load_ext sketchkit",
    "%%sketch --frames 1-3 --renderer cpu\n"
    "def setup():\n    size(20, 10)\n"
    "def draw():\n    background(0, 0, 200 + frameCount)\n",
    "def setup():\n    global spot\n    spot = createImage(3, 2, RGB)\n"
    "def draw():\n    background(255)\n    circle(-90, 0, 9)\n"
    "pictures = sketchkit.render(globals(), renderer='cpu')\nspot",
    "def draw():\n    elipse(1, 2, 3, 4)\nsketchkit.render(draw=draw, renderer='cpu')",
)


def test_cells_show_pictures_and_mistakes(tmp_path: Path) -> None:
    cells = [nbformat.v4.new_code_cell(text.replace("{root}", str(ROOT))) for text in CELLS]
    notebook = nbformat.v4.new_notebook(cells=cells)
    resources = {"metadata": {"path": str(tmp_path)}}

    nbclient.NotebookClient(
        notebook, kernel_name="python3", timeout=60, allow_errors=True, resources=resources
    ).execute()

    _, film, spot, mistake = (cell.outputs for cell in notebook.cells)
    with Image.open(BytesIO(base64.b64decode(film[0].data["image/png"]))) as picture:
        assert (picture.size, picture.n_frames) == ((20, 10), 3)
        assert picture.convert("RGB").getpixel((5, 5)) == (0, 0, 201)
    assert spot[0].text.startswith("notebook, line 6: circle(-90, 0, 9) does not show")
    with Image.open(BytesIO(base64.b64decode(spot[1].data["image/png"]))) as picture:
        assert picture.size == (3, 2)
    assert mistake[0].evalue.startswith("notebook, line 2: elipse is not defined.")

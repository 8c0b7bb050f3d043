import warnings

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from sketchkit.assets.models.loading import load_model
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from tests.assets.models.model_files import DATA, written
from tests.assets.models.test_gltf import BINARY
from tests.assets.models.test_ply import GOOD as BINARY_PLY
from tests.assets.models.test_stl import FACET, binary

GOOD = {
    "house.obj": (DATA / "house.obj").read_bytes(),
    "panel.ply": (DATA / "panel.ply").read_bytes(),
    "binary.ply": BINARY_PLY,
    "wedge.stl": (DATA / "wedge.stl").read_bytes(),
    "binary.stl": binary(FACET, FACET),
    "triangle.gltf": (DATA / "triangle.gltf").read_bytes(),
    "binary.glb": BINARY,
}
PIECES = [b"f ", b"v ", b"/", b"-1", b"0", b"9999999999999999999", b"nan", b"\n", b"\0", b"\\\n"]
PIECES += [b"mtllib house.mtl\n", b"usemtl brick\n", b"1e99", b"{}", b"[]", b"null", b",", b"\xff"]
many = settings(
    max_examples=200,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)


@pytest.mark.parametrize(
    "name", ["house.obj", "panel.ply", "wedge.stl", "triangle.gltf", "WEDGE.STL"]
)
def test_the_ending_tells_the_kind(tmp_path, name):
    path = written(tmp_path, name, GOOD[name.lower()])

    with warnings.catch_warnings(action="ignore", category=SketchWarning):
        assert load_model(path).parts


def test_an_ending_of_no_model_is_refused(tmp_path):
    with pytest.raises(SketchError, match="Models are OBJ, PLY, STL, GLTF or GLB files"):
        load_model(written(tmp_path, "a.blend", b"BLENDER"))


def test_a_file_that_cannot_be_read_is_told(tmp_path):
    with pytest.raises(SketchError, match="cannot be read"):
        load_model(tmp_path / "gone.obj")


def check(path):
    """Load what may be broken: it gives whole parts, or one error of ours."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.simplefilter("ignore", SketchWarning)
        try:
            model = load_model(path)
        except SketchError:
            return
    for part in model.parts:
        count = int(part.lengths.sum())
        assert part.places.shape == (count, 3)
        assert np.isfinite(part.places).all()
        for rows in (part.normals, part.uvs, part.colors):
            assert rows is None or (len(rows) == count and np.isfinite(rows).all())


@pytest.mark.parametrize("name", GOOD)
@many
@given(data=st.binary(max_size=300), keep=st.integers(0, 400))
def test_any_bytes_load_or_are_refused(tmp_path, name, data, keep):
    check(written(tmp_path, name, GOOD[name][:keep] + data))


@pytest.mark.parametrize("name", GOOD)
@many
@given(
    changes=st.lists(
        st.tuples(
            st.floats(0, 1), st.integers(0, 8), st.sampled_from(PIECES) | st.binary(max_size=4)
        ),
        min_size=1,
        max_size=4,
    )
)
def test_changed_files_load_or_are_refused(tmp_path, name, changes):
    data = GOOD[name]
    for place, removed, piece in changes:
        at = int(place * len(data))
        data = data[:at] + piece + data[at + removed :]

    check(written(tmp_path, name, data))

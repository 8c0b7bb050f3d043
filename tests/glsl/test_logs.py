"""Each driver has its own way to say where an error is."""

import pytest

from sketchkit.glsl.logs import Complaint, read_log

LOGS = {
    "Mesa": "GLSL Compiler failed\n\nfragment_shader\n===============\n"
    "0:12(5): warning: `a' used uninitialized\n0:12(7): error: `colr' undeclared\n\n",
    "NVIDIA": "GLSL Compiler failed\n\nfragment_shader\n===============\n"
    '0(12) : warning C7050: "a" might be used\n0(12) : error C1008: undefined variable "colr"\n',
    "AMD": "GLSL Compiler failed\n\nfragment_shader\n===============\n"
    "Fragment shader failed to compile with the following errors:\n"
    "ERROR: 0:12: error(#143) Undeclared identifier: colr\n"
    "ERROR: error(#273) 1 compilation errors.  No code generated\n",
    "Apple": "GLSL Compiler failed\n\nfragment_shader\n===============\n"
    "ERROR: 0:12: Use of undeclared identifier 'colr'\n",
    "ANGLE": "GLSL Compiler failed\n\nfragment_shader\n===============\n"
    "ERROR: 0:12: 'colr' : undeclared identifier\n",
}


@pytest.mark.parametrize("log", LOGS.values(), ids=LOGS)
def test_one_error_is_read_with_its_line(log):
    (complaint,) = read_log(log)

    assert (complaint.stage, complaint.line) == ("fragment", 12)
    assert "colr" in complaint.message
    assert not complaint.message.lower().startswith("error")


def test_error_of_the_link_has_no_line():
    log = "GLSL Linker failed\n\nProgram\n=======\nerror: fragment shader lacks `main'\n\n"

    assert read_log(log) == [Complaint("", 0, 0, "fragment shader lacks `main'")]


def test_log_of_nothing_has_no_errors():
    assert read_log("GLSL Compiler failed\n\n") == []

from sketchkit.reference.names import Name, every_name, names_by_owner


def test_table_has_functions_values_and_parts_of_classes() -> None:
    names = {(name.owner, name.name): name for name in every_name()}

    assert names["", "rect"].kind == "function"
    assert names["", "mouseX"].kind == "variable"
    assert names["PVector", "heading"].tier == 1
    assert len(names) > 3000


def test_every_name_is_one_that_python_can_read() -> None:
    assert [name for name in every_name() if not name.name.isidentifier()] == []
    assert {name.tier for name in every_name()} == {1, 2, 3}


def test_name_is_written_as_in_a_sketch() -> None:
    assert Name("", "rect", "function", 1, "").written == "rect()"
    assert Name("PVector", "mag", "method", 1, "").written == "PVector.mag()"
    assert Name("PVector", "x", "variable", 1, "").written == "PVector.x"
    assert Name("", "CENTER", "constant", 1, "").written == "CENTER"


def test_names_are_found_by_their_class() -> None:
    assert "dot" in names_by_owner()["PVector"]
    assert "rect" in names_by_owner()[""]
    assert "rect" not in names_by_owner()["PVector"]

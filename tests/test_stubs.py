import ast
import builtins

import pytest

from sketchkit.api.names import live_values
from sketchkit.runtime.visible_names import all_names
from sketchkit.stubs import blank_sketch, stub


@pytest.fixture(scope="module")
def tree() -> ast.Module:
    return ast.parse(stub())


def declared(tree: ast.Module) -> set[str]:
    """Return the names that an editor takes for built-in; a plain import is none of them."""
    names = set()
    for node in tree.body:
        match node:
            case ast.FunctionDef(name=name) | ast.ClassDef(name=name):
                names.add(name)
            case ast.AnnAssign(target=ast.Name(id=name)):
                names.add(name)
            case ast.ImportFrom(names=aliases):
                names |= {alias.asname for alias in aliases if alias.asname}
    return names


def known(tree: ast.Module) -> set[str]:
    """Return all names that the stub's annotations may use."""
    imported = {
        alias.asname or alias.name
        for node in tree.body
        if isinstance(node, ast.Import | ast.ImportFrom)
        for alias in node.names
    }
    return imported | declared(tree) | set(dir(builtins)) | {"_T"}


def definition(tree: ast.Module, name: str) -> ast.FunctionDef:
    return next(n for n in tree.body if isinstance(n, ast.FunctionDef) and n.name == name)


def test_every_name_of_a_sketch_is_declared(tree: ast.Module) -> None:
    seen = all_names(blank_sketch())

    assert seen.keys() - {"open"} == declared(tree)


def test_every_annotation_is_understood(tree: ast.Module) -> None:
    used = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}

    assert used <= known(tree)


def test_function_is_declared_as_it_is_called(tree: ast.Module) -> None:
    rect = definition(tree, "rect")

    assert [argument.arg for argument in rect.args.args[:4]] == ["a", "b", "c", "d"]
    assert "rectangle" in str(ast.get_docstring(rect))


def test_overloads_are_all_there(tree: ast.Module) -> None:
    forms = [n for n in tree.body if isinstance(n, ast.FunctionDef) and n.name == "random"]

    assert len(forms) == 3
    assert all(form.args.posonlyargs[0].arg != "self" for form in forms)


def test_live_values_have_types(tree: ast.Module) -> None:
    types = {
        node.target.id: ast.unparse(node.annotation)
        for node in tree.body
        if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name)
    }

    assert live_values(blank_sketch()).keys() <= types.keys()
    assert (types["mouseX"], types["key"], types["frameRate"]) == ("int", "str", "LiveFloat")


def test_two_stubs_are_the_same() -> None:
    assert stub() == stub()

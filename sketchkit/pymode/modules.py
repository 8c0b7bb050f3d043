"""Python 2's modules: those that have another name now, and those that have lost something."""

from __future__ import annotations

import builtins
import importlib
import itertools
import math
import operator
import random
import string
import sys
import time
from collections.abc import Callable, Mapping
from types import ModuleType
from typing import Any  # whatever the sketch calls them with

RENAMED = {
    "BaseHTTPServer": "http.server",
    "ConfigParser": "configparser",
    "Cookie": "http.cookies",
    "HTMLParser": "html.parser",
    "Queue": "queue",
    "SocketServer": "socketserver",
    "StringIO": "io",
    "Tkinter": "tkinter",
    "__builtin__": "builtins",
    "cPickle": "pickle",
    "cStringIO": "io",
    "copy_reg": "copyreg",
    "cookielib": "http.cookiejar",
    "exceptions": "builtins",
    "future_builtins": "builtins",
    "htmlentitydefs": "html.entities",
    "httplib": "http.client",
    "simplejson": "json",
    "thread": "_thread",
    "tkMessageBox": "tkinter.messagebox",
    "urllib2": "urllib.request",
    "urlparse": "urllib.parse",
}


class Python2Module(ModuleType):
    """A module as Python 2 has it: what is gone or was otherwise, and behind it Python 3's."""

    def __init__(self, name: str, behind: ModuleType, own: Mapping[str, object]) -> None:
        super().__init__(name, behind.__doc__)
        self._behind = behind
        public = [each for each in dir(behind) if not each.startswith("_")]
        self.__all__ = [*getattr(behind, "__all__", public), *own]
        vars(self).update(own)

    def __getattr__(self, name: str) -> object:
        return getattr(self._behind, name)

    def __dir__(self) -> list[str]:
        return sorted({*dir(self._behind), *vars(self)})


def python_2_module(name: str) -> ModuleType | None:
    """Return the module that Python 2 has by this name, if Python 3's would not do."""
    if name not in RENAMED and name not in ADDED:
        return None
    behind = importlib.import_module(RENAMED.get(name, name))
    make = ADDED.get(name)
    return Python2Module(name, behind, make() if make else {})


def _sys() -> dict[str, object]:
    return {"maxint": sys.maxsize, "setdefaultencoding": lambda encoding: None}


def _itertools() -> dict[str, object]:
    return {
        "ifilter": builtins.filter,
        "ifilterfalse": itertools.filterfalse,
        "imap": builtins.map,
        "izip": builtins.zip,
        "izip_longest": itertools.zip_longest,
    }


def _string() -> dict[str, object]:
    methods = (
        *("capitalize", "center", "count", "expandtabs", "find", "index", "ljust", "lower"),
        *("lstrip", "replace", "rfind", "rindex", "rjust", "rsplit", "rstrip", "split", "strip"),
        *("swapcase", "translate", "upper", "zfill"),
    )
    return {
        **{name: getattr(str, name) for name in methods},
        "atof": float,
        "atoi": int,
        "atol": int,
        "join": lambda words, between=" ": between.join(words),
        "joinfields": lambda words, between=" ": between.join(words),
        "letters": string.ascii_letters,
        "lowercase": string.ascii_lowercase,
        "maketrans": str.maketrans,
        "splitfields": str.split,
        "uppercase": string.ascii_uppercase,
    }


def _random() -> dict[str, object]:
    return {
        "jumpahead": lambda steps: None,
        "randint": lambda low, high: random.randint(int(low), int(high)),
        "randrange": lambda *bounds: random.randrange(*map(int, bounds)),
        "sample": lambda values, count: random.sample(list(values), int(count)),
        "shuffle": lambda values, how=None: random.shuffle(values),
    }


def _math() -> dict[str, object]:
    return {
        "ceil": lambda number: float(math.ceil(number)) if math.isfinite(number) else number,
        "floor": lambda number: float(math.floor(number)) if math.isfinite(number) else number,
        "factorial": lambda number: math.factorial(int(number)),
    }


def _operator() -> dict[str, object]:
    def div(a: Any, b: Any) -> Any:  # noqa: ANN401 # see the import
        return a // b if isinstance(a, int) and isinstance(b, int) else a / b

    return {"div": div, "isCallable": callable, "sequenceIncludes": operator.contains}


def _time() -> dict[str, object]:
    return {"clock": time.perf_counter}


def _collections() -> dict[str, object]:
    abstract = importlib.import_module("collections.abc")
    return {name: getattr(abstract, name) for name in abstract.__all__}


def _os() -> dict[str, object]:
    module = importlib.import_module("os")
    return {"getcwdu": module.getcwd}


def _types() -> dict[str, object]:
    kinds = (dict, float, int, list, tuple)
    return {f"{kind.__name__.capitalize()}Type": kind for kind in kinds} | {
        "BooleanType": bool,
        "LongType": int,
        "NoneType": type(None),
        "StringType": str,
        "StringTypes": (str,),
        "UnicodeType": str,
    }


def _csv() -> dict[str, object]:
    module = importlib.import_module("csv")

    def texts(lines: Any) -> Any:  # noqa: ANN401 # a file, or any lines
        for line in lines:
            yield line.decode("utf-8", "replace") if isinstance(line, bytes) else line

    return {
        "reader": lambda lines, *how, **named: module.reader(texts(lines), *how, **named),
        "DictReader": lambda lines, *how, **named: module.DictReader(texts(lines), *how, **named),
    }


def _fractions() -> dict[str, object]:
    return {"gcd": math.gcd}


def _urllib() -> dict[str, object]:
    parse = importlib.import_module("urllib.parse")
    request = importlib.import_module("urllib.request")
    return {
        "quote": parse.quote,
        "quote_plus": parse.quote_plus,
        "unquote": parse.unquote,
        "unquote_plus": parse.unquote_plus,
        "urlencode": parse.urlencode,
        "urlopen": request.urlopen,
        "urlretrieve": request.urlretrieve,
    }


ADDED: dict[str, Callable[[], dict[str, object]]] = {
    "collections": _collections,
    "csv": _csv,
    "fractions": _fractions,
    "itertools": _itertools,
    "math": _math,
    "operator": _operator,
    "os": _os,
    "random": _random,
    "string": _string,
    "sys": _sys,
    "time": _time,
    "types": _types,
    "urllib": _urllib,
}

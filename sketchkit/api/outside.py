"""What lies outside of the sketch: other programs, web pages, and files that the user chooses."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from sketchkit.api._sketch_parts import SketchParts
from sketchkit.api.folders import FilePath
from sketchkit.core.errors import SketchError, nearest, shown

Chosen = Callable[[FilePath | None], object]


class Outside(SketchParts):
    """`link()`, `launch()`, `selectInput()`: in `sketchkit render` they only say what they are."""

    def link(self, url: str) -> None:
        """Open a web page in the browser.

        Parameters
        ----------
        url : str
            Its address, with `https://` in front.

        See Also
        --------
        launch

        Examples
        --------
        >>> def mousePressed():
        ...     link("https://processing.org")
        """
        self._host.open_link(str(url))

    def launch(self, *args: str) -> None:
        """Open a file with the program that belongs to it, or start a program.

        Parameters
        ----------
        *args : str
            One: a file or an address. Several: a program and what it gets.

        See Also
        --------
        link

        Examples
        --------
        >>> def mousePressed():
        ...     launch(dataPath("poem.txt"))
        """
        if not args:
            raise SketchError(
                "launch() takes the name of a file, or a program and what it gets.", got="launch()"
            )
        self._host.launch([str(arg) for arg in args])

    def selectInput(self, prompt: str, callback: str | Chosen, file: str | None = None) -> None:
        """Let the user choose a file to read.

        Parameters
        ----------
        prompt : str
            What the user is asked for.
        callback : str or function
            One of the sketch's functions, or its name. It is called with the path of the file, a
            text that has `getAbsolutePath()` as well; with None if no file was chosen.
        file : str, optional
            Where to begin.

        See Also
        --------
        selectOutput, selectFolder

        Notes
        -----
        The sketch goes on meanwhile. Source: Processing's reference, selectInput().

        Examples
        --------
        >>> def fileChosen(path):
        ...     if path is not None:
        ...         println(path)
        >>> def mousePressed():
        ...     selectInput("A poem, please:", "fileChosen")
        """
        self._choose("input", "selectInput", prompt, callback, file)

    def selectOutput(self, prompt: str, callback: str | Chosen, file: str | None = None) -> None:
        """Let the user choose a file to write.

        Parameters
        ----------
        prompt, callback, file :
            As those of `selectInput()`.

        See Also
        --------
        selectInput, selectFolder

        Examples
        --------
        >>> def fileChosen(path):
        ...     if path is not None:
        ...         saveStrings(path, ["anna 12"])
        >>> def mousePressed():
        ...     selectOutput("Where to?", "fileChosen")
        """
        self._choose("output", "selectOutput", prompt, callback, file)

    def selectFolder(self, prompt: str, callback: str | Chosen, file: str | None = None) -> None:
        """Let the user choose a folder.

        Parameters
        ----------
        prompt, callback, file :
            As those of `selectInput()`.

        See Also
        --------
        selectInput, selectOutput

        Examples
        --------
        >>> def folderChosen(path):
        ...     if path is not None:
        ...         println(path)
        >>> def mousePressed():
        ...     selectFolder("Which one?", "folderChosen")
        """
        self._choose("folder", "selectFolder", prompt, callback, file)

    def _choose(
        self, kind: str, name: str, prompt: str, callback: str | Chosen, file: str | None
    ) -> None:
        function = self._function_for(name, callback)
        start = str(self.folder if file is None else self.folder / str(file))

        def chosen(path: str | None) -> None:
            self.progress.due_calls.append(partial(function, FilePath(path) if path else None))

        self._host.choose_file(kind, str(prompt), start, chosen)

    def _function_for(self, caller: str, callback: str | Chosen) -> Chosen:
        function = self.namespace.get(callback) if isinstance(callback, str) else callback
        if callable(function):
            return function
        functions = [own for own, value in self.namespace.items() if callable(value)]
        known = nearest(str(callback), functions)
        raise SketchError(
            f"{caller}() takes a text and one of your functions, or its name.",
            got=f"{shown(callback)} for the function",
            hint=f"Do you mean {known}?" if known else "It takes one value, the file's path.",
        )

"""Files with structure: tables, JSON and XML, read and written."""

from __future__ import annotations

from typing import cast

from sketchkit.api._sketch_parts import SketchParts
from sketchkit.api.data.faults import wrong_kind
from sketchkit.api.data.json.json_array import JSONArray
from sketchkit.api.data.json.json_object import JSONObject
from sketchkit.api.data.json.values import parsed, parsed_or_none
from sketchkit.api.data.sources import read_bytes, read_text
from sketchkit.api.data.tables.table import Table
from sketchkit.api.data.xml.xml import XML


class DataFiles(SketchParts):
    """`loadTable()`, `saveJSONObject()` and the like. Names without a folder mean the sketch's."""

    def loadTable(self, filename: str, options: str | None = None) -> Table:
        """Read a table from a file: CSV, with commas between cells, or TSV, with tabs.

        Parameters
        ----------
        filename : str
            Looked for in the sketch's `data` folder, then beside the sketch. Also an address,
            "https://...", where a window is shown.
        options : str, optional
            `"header"` if its first line has titles; `"csv"` or `"tsv"` if its name does not say;
            `"encoding=latin-1"` if it is not in UTF-8; `"dictionary=types.tsv"` for a file with
            the title and the type of each column. Several with commas between: `"header, tsv"`.

        Raises
        ------
        SketchError
            If there is no such file, or its quotes are wrong; it tells the line.

        See Also
        --------
        saveTable, loadStrings

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> for row in table.rows():
        ...     println(row.getString("name"), row.getInt("age"))
        Ida 12
        Ben 9
        """
        return Table.read("loadTable", filename, options)

    def saveTable(self, table: Table, filename: str, options: str | None = None) -> bool:
        """Write a table into a file.

        Parameters
        ----------
        table : Table
            The table.
        filename : str
            Written beside the sketch. It ends in `.csv`, `.tsv` or `.html`.
        options : str, optional
            `"csv"`, `"tsv"` or `"html"` if the name does not say.

        See Also
        --------
        loadTable

        Examples
        --------
        >>> table = Table()
        >>> table.setString(0, 0, "Ida")
        >>> saveTable(table, "names.csv")
        True
        """
        if not isinstance(table, Table):
            raise wrong_kind("saveTable", "a Table and the name of a file", table)
        return table.save(filename, options)

    def loadJSONObject(self, filename: str) -> JSONObject:
        """Read a file of JSON that holds an object, {...}.

        Parameters
        ----------
        filename : str
            As for `loadTable()`.

        Raises
        ------
        SketchError
            If there is no such file, or it is no JSON; it tells the line.

        See Also
        --------
        loadJSONArray, parseJSONObject, saveJSONObject

        Examples
        --------
        >>> json = loadJSONObject("lion.json")
        >>> json.getString("species"), json.getInt("id")
        ('Panthera leo', 1)
        """
        text = read_text("loadJSONObject", filename)
        return cast("JSONObject", parsed(filename, text, dict))

    def loadJSONArray(self, filename: str) -> JSONArray:
        """Read a file of JSON that holds an array, [...].

        Parameters
        ----------
        filename : str
            As for `loadTable()`.

        Raises
        ------
        SketchError
            If there is no such file, or it is no JSON; it tells the line.

        See Also
        --------
        loadJSONObject, parseJSONArray, saveJSONArray

        Examples
        --------
        >>> saveJSONArray(JSONArray([3, 4]), "data/scores.json")
        True
        >>> loadJSONArray("scores.json").getInt(1)
        4
        """
        text = read_text("loadJSONArray", filename)
        return cast("JSONArray", parsed(filename, text, list))

    def parseJSONObject(self, input: str) -> JSONObject | None:
        """Return the object that a text in JSON holds.

        Parameters
        ----------
        input : str
            The text.

        Returns
        -------
        JSONObject or None
            None, and a remark, if it holds none.

        See Also
        --------
        loadJSONObject, parseJSONArray

        Examples
        --------
        >>> parseJSONObject('{"id": 3}').getInt("id")
        3
        """
        return cast("JSONObject | None", parsed_or_none("parseJSONObject", input, dict))

    def parseJSONArray(self, input: str) -> JSONArray | None:
        """Return the array that a text in JSON holds.

        Parameters
        ----------
        input : str
            The text.

        Returns
        -------
        JSONArray or None
            None, and a remark, if it holds none.

        See Also
        --------
        loadJSONArray, parseJSONObject

        Examples
        --------
        >>> parseJSONArray("[1, 2, 3]").size()
        3
        """
        return cast("JSONArray | None", parsed_or_none("parseJSONArray", input, list))

    def saveJSONObject(self, json: JSONObject, filename: str, options: str | None = None) -> bool:
        """Write an object into a file of JSON.

        Parameters
        ----------
        json : JSONObject
            The object; Python's own dictionaries do as well.
        filename : str
            Written beside the sketch.
        options : str, optional
            `"compact"` for a single line, or `"indent=4"`.

        See Also
        --------
        loadJSONObject, saveJSONArray

        Examples
        --------
        >>> saveJSONObject(JSONObject({"score": 12}), "game.json")
        True
        """
        if isinstance(json, dict):
            json = JSONObject(json)
        if not isinstance(json, JSONObject):
            takes = "a JSONObject and the name of a file"
            raise wrong_kind("saveJSONObject", takes, json, "An array is saved by saveJSONArray().")
        return json.save(filename, options)

    def saveJSONArray(self, json: JSONArray, filename: str, options: str | None = None) -> bool:
        """Write an array into a file of JSON.

        Parameters
        ----------
        json : JSONArray
            The array; Python's own lists do as well.
        filename : str
            Written beside the sketch.
        options : str, optional
            `"compact"` for a single line, or `"indent=4"`.

        See Also
        --------
        loadJSONArray, saveJSONObject

        Examples
        --------
        >>> saveJSONArray(JSONArray([3, 4]), "scores.json", "compact")
        True
        """
        if isinstance(json, list):
            json = JSONArray(json)
        if not isinstance(json, JSONArray):
            takes = "a JSONArray and the name of a file"
            raise wrong_kind(
                "saveJSONArray", takes, json, "An object is saved by saveJSONObject()."
            )
        return json.save(filename, options)

    def loadXML(self, filename: str, options: str | None = None) -> XML:
        """Read a document in XML, and return its root element.

        Parameters
        ----------
        filename : str
            As for `loadTable()`.
        options : str, optional
            None has a meaning.

        Raises
        ------
        SketchError
            If there is no such file, or it is not well-formed; it tells the line.

        See Also
        --------
        parseXML, saveXML

        Examples
        --------
        >>> xml = loadXML("zoo.xml")
        >>> for animal in xml.getChildren("animal"):
        ...     println(animal.getInt("id"), animal.getContent())
        1 Lion
        """
        return XML.read(filename, read_bytes("loadXML", filename))

    def parseXML(self, xmlString: str, options: str | None = None) -> XML:
        """Return the root element of a document that a text holds.

        Parameters
        ----------
        xmlString : str
            The text.
        options : str, optional
            None has a meaning.

        See Also
        --------
        loadXML, saveXML

        Examples
        --------
        >>> parseXML("<zoo><animal>Lion</animal></zoo>").getChild("animal").getContent()
        'Lion'
        """
        return XML.read("The text", xmlString)

    def saveXML(self, xml: XML, filename: str, options: str | None = None) -> bool:
        """Write an element, and all that stands in it, into a file.

        Parameters
        ----------
        xml : XML
            The element.
        filename : str
            Written beside the sketch.
        options : str, optional
            None has a meaning.

        See Also
        --------
        loadXML, parseXML

        Examples
        --------
        >>> saveXML(XML("zoo"), "empty.xml")
        True
        """
        if not isinstance(xml, XML):
            raise wrong_kind("saveXML", "XML and the name of a file", xml)
        return xml.save(filename)

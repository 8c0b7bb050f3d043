"""A sweep that tells the order of its regions: that of the faces in GLU's mesh.

GLU keeps the polygon as a mesh, and each time that the sweep connects two vertices or lets edges
cross, faces are split and joined, and so change places. Here the same is done to a mesh, beside
the sweep. Where much coincides the order may come out different from GLU's.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import NamedTuple

from sketchkit.geometry.mesh import Half, Mesh
from sketchkit.geometry.predicates import Place, side
from sketchkit.geometry.sweep import Corner, Edge, Region, Ring, Sweep, Vertex

FAR = 4e150  # GLU's two edges around everything, below and above, end here


class _Bridge(NamedTuple):
    """GLU's guess at the diagonal from where two regions met: it leads to a vertex ahead.

    It stays if that is the region's next vertex indeed, and else gives way to the right diagonal.
    """

    half: Half
    left: Place
    right: Place


class OrderedSweep(Sweep):
    """A sweep whose regions can be put in order. In the mesh an edge is its half that goes left."""

    def __init__(
        self, rings: Iterable[Ring], first_free: int, is_inside: Callable[[int], bool]
    ) -> None:
        self._mesh = Mesh()
        self._halves: dict[Edge, Half] = {}
        self._leaving: dict[Vertex, Half] = {}  # a half-edge that starts at each vertex
        self._tops: dict[int, Half] = {}  # above each finished region, by the id of its corners
        self._bridges: dict[Edge | None, _Bridge] = {}  # by the edge below
        self._splices: list[tuple[Half, Half]] = []  # where edges cross: GLU does these last
        self._vertex: Vertex | None = None  # that of the stop
        self._position = 0  # of the stop on the line
        self._lefts: list[Half] = []  # half-edges from the stop to the left, from the top down
        super().__init__(rings, first_free, is_inside)
        self._lowest, self._highest = self._mesh.edge(), self._mesh.edge()

    def order(self) -> list[int]:
        """Return the indices of the regions in the order of GLU's faces."""
        ranks = self._mesh.ranks()
        places = [ranks.get(self._tops[id(corners)].face, 0) for corners in self.regions]
        return sorted(range(len(places)), key=places.__getitem__)

    def _add_ring(self, ring: Ring) -> None:
        known = len(self._stops)
        super()._add_ring(ring)
        vertices = [vertex for _, _, vertex in self._stops[known:]]
        if not vertices:
            return
        vertices.insert(0, vertices.pop())  # as in the ring
        halves = self._mesh.ring(len(vertices))
        for vertex, half in zip(vertices, halves, strict=True):
            self._leaving[vertex] = half
            for edge in vertex.starting:
                self._halves[edge] = half.twin if edge.winding > 0 else half.behind
        self._leaving[vertices[0]] = halves[-1].twin

    def _merge(self, vertex: Vertex, other: Vertex) -> None:
        self._mesh.splice(self._leaving[vertex], self._leaving[other])
        super()._merge(vertex, other)

    def _cut(self, edge: Edge, vertex: Vertex) -> Edge:
        rest = super()._cut(edge, vertex)
        half = self._mesh.split(self._halves[edge].twin)
        self._halves[rest] = half.twin
        if vertex is self._vertex:
            self._mesh.splice(self._leaving[vertex], half.turned)
        else:
            self._leaving.setdefault(vertex, half)
        return rest

    def _meet(self, low: Edge, up: Edge, vertex: Vertex) -> None:
        super()._meet(low, up, vertex)
        low_half, up_half = self._halves[low], self._halves[up]
        self._splices.append((low_half.turned_back, up_half.turned_back))

    def _drop(self, edge: Edge) -> None:
        super()._drop(edge)
        self._mesh.delete(self._halves[edge])

    def _stop(self, vertex: Vertex) -> None:
        self._vertex = vertex
        self._lefts.clear()
        super()._stop(vertex)
        if self._lefts and not vertex.starting:
            self._add_bridge(vertex)
        while self._splices:
            self._cross_edges()

    def _settle(self, vertex: Vertex, position: int, count: int) -> None:
        self._position = position
        super()._settle(vertex, position, count)

    def _end_regions(self, vertex: Vertex, below: Region, ended: list[Edge]) -> Region:
        if bridge := self._bridges.pop(ended[-1], None):
            top = self._halves[ended[-1]]
            half = self._reach(bridge, vertex, top.twin, bridge.half.ahead)
            self._add_left(half, ended[-1].region.lower)
        lower_edges = [*ended[-2::-1], self._under()]
        regions = [*(edge.region for edge in ended[-2::-1]), below]
        for edge, lower, region in zip(ended[::-1], lower_edges, regions, strict=True):
            self._add_left(self._halves[edge], region.upper)
            if bridge := self._bridges.pop(lower, None):
                half = self._reach(bridge, vertex, self._lefts[-1].behind, bridge.half.twin)
                self._add_left(half, region.lower)
        return super()._end_regions(vertex, below, ended)

    def _part_region(self, vertex: Vertex, region: Region, position: int, count: int) -> Region:
        bridge = self._bridges.pop(self._under(), None)
        if bridge:
            is_above = side(bridge.left, vertex.place, bridge.right) > 0
            self._lefts.append(self._part(vertex, bridge.half, is_above=is_above))
            self._mesh.delete(bridge.half)
        elif region.lower:
            low, up = self._line[position - 1], self._line[position + count]
            is_above = low.left.place > up.left.place
            nearer = self._halves[low if is_above else up]
            self._lefts.append(self._part(vertex, nearer, is_above=is_above))
        return super()._part_region(vertex, region, position, count)

    def _start_regions(self, vertex: Vertex, winding: int, started: list[Edge]) -> None:
        rights = [self._halves[edge].twin for edge in reversed(started)]
        above = self._lefts[0] if self._lefts else rights[0].turned
        for half in rights:
            if half.turned is not above:
                self._mesh.splice(half.turned_back, half)
                self._mesh.splice(above.turned_back, half)
            above = half
        super()._start_regions(vertex, winding, started)

    def _cross_edges(self) -> None:
        """Make one vertex of the two where the edges that met first have been cut."""
        low, up = self._splices.pop(0)
        self._mesh.splice(low, up.turned)

    def _under(self) -> Edge | None:
        """Return the edge on the line below the stop."""
        return self._line[self._position - 1] if self._position else None

    def _add_left(self, half: Half, corners: list[Corner]) -> None:
        """Add what is next around the vertex of the stop; the region below it has `corners`."""
        if self._lefts and self._lefts[-1].turned is not half:
            self._mesh.splice(half.turned_back, half)
            self._mesh.splice(self._lefts[-1], half)
        self._lefts.append(half)
        self._tops[id(corners)] = half

    def _reach(self, bridge: _Bridge, vertex: Vertex, start: Half, end: Half) -> Half:
        """Return the diagonal from `vertex` to where the bridge comes from."""
        if bridge.right == vertex.place:
            return bridge.half
        half = self._mesh.connect(start, end)
        self._mesh.delete(bridge.half)
        return half

    def _part(self, vertex: Vertex, half: Half, *, is_above: bool) -> Half:
        """Return a diagonal from `vertex`, which is above or below an edge, to where that ends."""
        start = self._leaving[vertex]
        if is_above:
            return self._mesh.connect(half.twin.behind, start).twin
        return self._mesh.connect(start.twin, half.ahead)

    def _add_bridge(self, vertex: Vertex) -> None:
        """Connect a vertex where all edges end to the nearer of the right ends around it."""
        if self._splices:
            self._cross_edges()
        low, low_half, low_end = None, self._lowest, (FAR, -FAR)
        if self._position:
            low = self._line[self._position - 1]
            low_half, low_end = self._halves[low], low.right.place
        up_half, up_end = self._highest, (FAR, FAR)
        if self._position < len(self._line):
            up = self._line[self._position]
            up_half, up_end = self._halves[up], up.right.place
        end = low_half.turned_back if low_end <= up_end else up_half
        half = self._mesh.connect(self._lefts[-1].behind, end).twin
        self._bridges[low] = _Bridge(half, vertex.place, min(low_end, up_end))

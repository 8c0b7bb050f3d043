"""Part polygons of any kind into monotone regions, by sweeping a line over them.

The method is that of the GLU tessellator, which Processing uses, down to the diagonals. The line
moves from left to right and stops at every vertex; between two neighbouring edges on it lies a
region. A region inside the polygon is kept monotone: where it would not be, a diagonal parts it.
"""

from __future__ import annotations

import functools
import heapq
from collections.abc import Callable, Iterable

from sketchkit.geometry.predicates import Place, crossing, side

Ring = list[tuple[Place, int]]  # place and index of each point, in order
Corner = tuple[Place, int, bool]  # place, index, and whether it is on its region's upper side
Blend = tuple[tuple[int, ...], tuple[float, ...]]  # sources and weights of a new point


class Vertex:
    """A stop of the line, with the edges that end and begin there."""

    __slots__ = ("ending", "index", "place", "starting")

    def __init__(self, place: Place, index: int) -> None:
        self.place = place
        self.index = index
        self.ending: list[Edge] = []
        self.starting: list[Edge] = []


class Edge:
    """An edge, from left to right; whoever crosses it upwards adds `winding`."""

    __slots__ = ("left", "region", "right", "winding")

    def __init__(self, left: Vertex, right: Vertex, winding: int) -> None:
        self.left = left
        self.right = right
        self.winding = winding
        self.region = _OUTSIDE  # the one above, once the edge is on the line
        left.starting.append(self)
        right.ending.append(self)

    def cut(self, vertex: Vertex) -> Edge:
        """End at `vertex`; return the rest, an edge that begins there."""
        self.right.ending.remove(self)
        rest = Edge(vertex, self.right, self.winding)
        self.right = vertex
        vertex.ending.append(self)
        return rest

    def drop(self) -> None:
        """Leave the graph."""
        self.left.starting.remove(self)
        self.right.ending.remove(self)


class Region:
    """What lies between two neighbouring edges on the line.

    A region inside the polygon holds its corners so far, from left to right, twice the same list.
    Where two regions have met it holds the lists of both, lower and upper, which end with the
    vertex where they met. The region's next vertex is joined to that one, and the two part again.
    """

    __slots__ = ("lower", "upper", "winding")

    def __init__(self, winding: int, lower: list[Corner], upper: list[Corner]) -> None:
        self.winding = winding
        self.lower = lower
        self.upper = upper


_OUTSIDE = Region(0, [], [])


class Sweep:
    """One sweep over a set of rings: the line's edges, the stops ahead, and what was found.

    Parameters
    ----------
    rings : iterable of Ring
        Without a last point that repeats the first.
    first_free : int
        The index that the first new point gets.
    is_inside : callable
        Whether a winding number means inside.

    Attributes
    ----------
    regions : list of lists of Corner
        The monotone regions inside the polygon; the corners of each are sorted by place.
    blends : list of Blend
        The new points, where edges cross or points coincide: mixtures of the points before them.
    """

    def __init__(
        self, rings: Iterable[Ring], first_free: int, is_inside: Callable[[int], bool]
    ) -> None:
        self.regions: list[list[Corner]] = []
        self.blends: list[Blend] = []
        self._first_free = first_free
        self._is_inside = is_inside
        self._stops: list[tuple[Place, int, Vertex]] = []  # the middle one: GLU's order of equals
        self._line: list[Edge] = []  # from the bottom up
        for ring in rings:
            self._add_ring(ring)
        heapq.heapify(self._stops)
        # Two edges cross once at most. Rounding may add some, but must not keep us here for ever.
        self._crossings_left = len(self._stops) ** 2

    def run(self) -> None:
        """Move the line over all stops."""
        while self._stops:
            place, _, vertex = heapq.heappop(self._stops)
            while self._stops and self._stops[0][0] == place:
                self._merge(vertex, heapq.heappop(self._stops)[2])
            self._stop(vertex)

    def _add_ring(self, ring: Ring) -> None:
        """Add the edges of a ring; of points that follow each other at one place, the middle."""
        corners: Ring = []
        for place, index in ring[:1] + ring[:0:-1]:  # backwards from the first, as GLU
            if corners and corners[-1][0] == place:
                corners[-1] = place, self._middle(index, corners[-1][1])
            else:
                corners.append((place, index))
        if len(corners) > 1 and corners[0][0] == corners[-1][0]:
            place, index = corners.pop()
            corners[0] = place, self._middle(index, corners[0][1])
        if len(corners) < 3:
            return
        corners.reverse()
        vertices = [Vertex(place, index) for place, index in corners]
        for order, vertex in enumerate(vertices, len(self._stops)):
            self._stops.append((vertex.place, -order, vertex))
        for start, end in zip(vertices, vertices[1:] + vertices[:1], strict=True):
            if start.place < end.place:
                Edge(start, end, 1)
            else:
                Edge(end, start, -1)

    def _middle(self, first: int, second: int) -> int:
        return self._blend((first, second), (0.5, 0.5))

    def _blend(self, sources: tuple[int, ...], weights: tuple[float, ...]) -> int:
        self.blends.append((sources, weights))
        return self._first_free + len(self.blends) - 1

    def _merge(self, vertex: Vertex, other: Vertex) -> None:
        """Give the edges of `other`, at the same place, to `vertex`, which becomes their middle."""
        vertex.index = self._middle(vertex.index, other.index)
        for edge in other.ending:
            edge.right = vertex
        for edge in other.starting:
            edge.left = vertex
        vertex.ending += other.ending
        vertex.starting += other.starting

    def _stop(self, vertex: Vertex) -> None:
        """Let the edges that end at `vertex` leave the line, and those that begin there enter."""
        position = self._locate(vertex)
        ended: list[Edge] = []
        while True:
            position = self._take_ended(vertex, position, ended)
            started = self._merge_starting(vertex)
            self._line[position:position] = started
            self._settle(vertex, position, len(started))
            if len(vertex.ending) == len(ended):
                break
            del self._line[position : position + len(started)]  # a neighbour was cut: once more
        below = self._line[position - 1].region if position else _OUTSIDE
        if ended:
            above = self._end_regions(vertex, below, ended)
        else:
            above = self._part_region(vertex, below, position, len(started))
        if started:
            self._start_regions(vertex, below.winding, started)
            started[-1].region = above
        elif position:
            met = Region(below.winding, below.lower, above.upper)
            self._line[position - 1].region = met

    def _cut(self, edge: Edge, vertex: Vertex) -> Edge:
        return edge.cut(vertex)

    def _meet(self, low: Edge, up: Edge, vertex: Vertex) -> None:
        """Let both edges end at `vertex`."""
        for edge in (up, low):
            if edge.right is not vertex:
                self._cut(edge, vertex)

    def _drop(self, edge: Edge) -> None:
        edge.drop()

    def _locate(self, vertex: Vertex) -> int:
        """Return the position on the line of an edge that ends at `vertex`, else of `vertex`.

        An edge that happens to pass through `vertex` is made to end there.
        """
        line = self._line
        if vertex.ending:
            return line.index(vertex.ending[0])
        first, last = 0, len(line)
        while first < last:
            middle = (first + last) // 2
            edge = line[middle]
            if side(edge.left.place, vertex.place, edge.right.place) > 0:
                first = middle + 1
            else:
                last = middle
        if first < len(line):
            edge = line[first]
            if side(edge.left.place, vertex.place, edge.right.place) == 0:
                self._cut(edge, vertex)
        return first

    def _take_ended(self, vertex: Vertex, position: int, ended: list[Edge]) -> int:
        """Move the edges that end at `vertex` from the line to `ended`; return where they were."""
        line = self._line
        while position and line[position - 1].right is vertex:
            position -= 1
            ended.insert(0, line.pop(position))
        while position < len(line) and line[position].right is vertex:
            ended.append(line.pop(position))
        if len(ended) < len(vertex.ending):
            # Rounding has left other edges between: they pass through the vertex, near enough.
            strays = [line.index(edge) for edge in vertex.ending if edge not in ended]
            for edge in line[min(position, *strays) : max(position, *strays)]:
                if edge.right is not vertex:
                    self._cut(edge, vertex)
            return self._take_ended(vertex, position, ended)
        return position

    def _settle(self, vertex: Vertex, position: int, count: int) -> None:
        """Cut edges at `position` wherever two that have become neighbours meet, and so on.

        `count` edges there are new. All is in order again when this returns, unless an edge was
        cut at `vertex` itself.
        """
        line = self._line
        pairs = [position + count - 1, position - 1] if count else [position - 1]
        while pairs:
            pair = pairs.pop()
            if not 0 <= pair < len(line) - 1:
                continue
            low, up = line[pair], line[pair + 1]
            low_end, up_end = low.right, up.right
            if low_end is up_end:
                continue
            have_met = not count and pair == position - 1 and low.left is not up.left
            if have_met or (low.left is vertex) != (up.left is vertex):
                self._cross(low, up, vertex)
            else:
                self._cut_longer(low, up)
            if low.right is vertex or up.right is vertex:
                return
            if up.right is not up_end:
                pairs.append(pair + 1)
            if low.right is not low_end:
                pairs.append(pair - 1)

    def _cross(self, low: Edge, up: Edge, stop: Vertex) -> None:
        """Cut two edges where they cross, right of the line or, at the least, on it."""
        a, b, c, d = low.left.place, low.right.place, up.left.place, up.right.place
        if min(c[1], d[1]) > max(a[1], b[1]):
            return
        if side(a, d, b) > 0 if d < b else side(c, b, d) < 0:
            return
        place = min(max(crossing(c, d, a, b), stop.place), b, d)
        if place in (b, d):
            self._cut_longer(low, up)
            return
        if up.left is not stop and side(c, stop.place, place) >= 0:
            self._cut(up, stop)
        if low.left is not stop and side(a, stop.place, place) <= 0:
            self._cut(low, stop)
        if low.right is not stop and up.right is not stop and self._crossings_left:
            self._crossings_left -= 1
            vertex = self._crossing_vertex(place, up, low)
            self._meet(low, up, vertex)

    def _crossing_vertex(self, place: Place, up: Edge, low: Edge) -> Vertex:
        """Return the vertex where two edges cross: half of either edge, the nearer end more."""
        ends = (up.right, up.left, low.right, low.left)
        gaps = [abs(place[0] - end.place[0]) + abs(place[1] - end.place[1]) for end in ends]
        weights = (
            0.5 * gaps[1] / (gaps[0] + gaps[1]),
            0.5 * gaps[0] / (gaps[0] + gaps[1]),
            0.5 * gaps[3] / (gaps[2] + gaps[3]),
            0.5 * gaps[2] / (gaps[2] + gaps[3]),
        )
        vertex = Vertex(place, self._blend(tuple(end.index for end in ends), weights))
        heapq.heappush(self._stops, (place, -vertex.index, vertex))
        return vertex

    def _cut_longer(self, low: Edge, up: Edge) -> None:
        """Cut the edge that goes further where the other ends, unless that end is in order."""
        low_end, up_end = low.right.place, up.right.place
        if low_end < up_end:
            if side(up.left.place, low_end, up_end) >= 0:
                self._meet(low, up, low.right)
        elif low_end > up_end:
            if side(low.left.place, up_end, low_end) <= 0:
                self._meet(low, up, up.right)
        elif low.right is not up.right:
            self._stops = [stop for stop in self._stops if stop[2] is not up.right]
            heapq.heapify(self._stops)
            self._merge(low.right, up.right)

    def _merge_starting(self, vertex: Vertex) -> list[Edge]:
        """Return the edges that start at a vertex, from the bottom up, one for each direction."""
        if len(vertex.starting) < 2:
            return vertex.starting[:]
        vertex.starting.sort(key=functools.cmp_to_key(_compare_slopes))
        low, *others = vertex.starting
        for up in others:
            self._cut_longer(low, up)
            if low.right is up.right:
                up.winding += low.winding
                self._drop(low)
            low = up
        return vertex.starting[:]

    def _end_regions(self, vertex: Vertex, below: Region, ended: list[Edge]) -> Region:
        """Make `vertex` a corner of the regions next to the ended edges; return the one above."""
        place, index = vertex.place, vertex.index
        if below.lower:
            if below.upper is not below.lower:
                self._finish(below.upper, vertex)
                below.upper = below.lower
            below.lower.append((place, index, True))
        for edge in ended[:-1]:
            region = edge.region
            if region.lower:
                self._finish(region.lower, vertex)
                if region.upper is not region.lower:
                    self._finish(region.upper, vertex)
        above = ended[-1].region
        if above.lower:
            if above.upper is not above.lower:
                self._finish(above.lower, vertex)
                above.lower = above.upper
            above.upper.append((place, index, False))
        return above

    def _finish(self, corners: list[Corner], vertex: Vertex) -> None:
        if len(corners) > 1:
            corners.append((vertex.place, vertex.index, False))
            self.regions.append(corners)

    def _part_region(self, vertex: Vertex, region: Region, position: int, count: int) -> Region:
        """Part the region that `vertex` lies in by a diagonal; return the one above, keep the rest.

        The diagonal goes to the vertex where two regions have met, else to the last one before.
        """
        if not region.lower:
            return region
        on_lower, on_upper = (vertex.place, vertex.index, False), (vertex.place, vertex.index, True)
        above = region.upper
        if region.upper is region.lower:
            low, up = self._line[position - 1].left, self._line[position + count].left
            if low.place <= up.place:
                above = [(up.place, up.index, True)]
            else:
                region.lower = [(low.place, low.index, False)]
        above.append(on_lower)
        region.lower.append(on_upper)
        region.upper = region.lower
        return Region(region.winding, above, above)

    def _start_regions(self, vertex: Vertex, winding: int, started: list[Edge]) -> None:
        """Begin the regions between the edges that start at `vertex`."""
        for edge in started[:-1]:
            winding += edge.winding
            is_inside = self._is_inside(winding)
            corners = [(vertex.place, vertex.index, False)] if is_inside else []
            edge.region = Region(winding, corners, corners)


def _compare_slopes(a: Edge, b: Edge) -> int:
    """Return 1 if the first of two edges from one vertex is the upper, -1 the lower, 0 neither."""
    start, end_a, end_b = a.left.place, a.right.place, b.right.place
    above = side(start, end_a, end_b) if end_a < end_b else -side(start, end_b, end_a)
    return (above > 0) - (above < 0)

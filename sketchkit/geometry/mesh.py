"""A mesh of half-edges whose faces stand in a list, in the order that GLU's operations give it.

A face here is a loop of half-edges, with itself on their left. What splits a face puts the new one
before the old into the list; what joins two takes one away. The places of faces outlive that.
"""

from __future__ import annotations


class Face:
    """A place in the list of faces, which is a ring."""

    __slots__ = ("after", "before")

    def __init__(self) -> None:
        self.after = self.before = self

    def insert(self) -> Face:
        """Put a new face before this one."""
        face = Face()
        face.after, face.before = self, self.before
        self.before.after = self.before = face
        return face

    def remove(self) -> None:
        """Leave the list."""
        self.before.after, self.after.before = self.after, self.before


class Half:
    """One side of an edge, from its origin to the origin of its twin.

    Attributes
    ----------
    twin : Half
    ahead : Half
        The next in the loop around the face.
    turned : Half
        The next around the origin, counter-clockwise.
    face : Face
    """

    __slots__ = ("ahead", "face", "turned", "twin")

    def __init__(self, face: Face, twin: Half | None = None) -> None:
        self.face = face
        self.turned = self
        self.twin = self.ahead = twin or Half(face, self)

    @property
    def turned_back(self) -> Half:
        """The next around the origin, clockwise."""
        return self.twin.ahead

    @property
    def behind(self) -> Half:
        """The one before in the loop around the face."""
        return self.turned.twin

    def fill(self, face: Face) -> None:
        """Make `face` that of the whole loop."""
        half = self
        while half.face is not face:
            half.face = face
            half = half.ahead


class Mesh:
    """Half-edges and their faces."""

    def __init__(self) -> None:
        self._end = Face()

    def ranks(self) -> dict[Face, int]:
        """Return the position of each face in the list."""
        faces: dict[Face, int] = {}
        face = self._end.after
        while face is not self._end:
            faces[face] = len(faces)
            face = face.after
        return faces

    def edge(self) -> Half:
        """Add an edge that touches no other."""
        return Half(self._end.insert())

    def ring(self, count: int) -> list[Half]:
        """Add a ring of edges; return their halves that have the first face of two on the right."""
        half = self.edge()
        self.splice(half, half.twin)
        halves = [half]
        while len(halves) < count:
            halves.append(self.split(halves[-1]))
        return halves

    def splice(self, half: Half, other: Half) -> None:
        """Swap what is next around two origins: parts a common origin, or makes two one."""
        if half is other:
            return
        is_apart = half.face is not other.face
        if is_apart:
            self._join_faces(other, half.face)
        _swap(other, half)
        if not is_apart:
            other.fill(half.face.insert())

    def split(self, half: Half) -> Half:
        """Halve an edge; return the second part of `half`."""
        rest = Half(half.face).twin
        _swap(rest.twin, half.ahead)
        _swap(half.twin, half.twin.turned_back)
        _swap(half.twin, rest)
        rest.twin.face = half.twin.face
        return rest

    def connect(self, half: Half, other: Half) -> Half:
        """Add an edge from the end of `half` to the origin of `other`; their faces are its left."""
        is_apart = half.face is not other.face
        if is_apart:
            self._join_faces(other, half.face)
        new = Half(half.face)
        _swap(new, half.ahead)
        _swap(new.twin, other)
        if not is_apart:
            new.fill(half.face.insert())
        return new

    def delete(self, half: Half) -> None:
        """Take an edge out; the face on the left of `half` goes with it, if there are two."""
        is_apart = half.face is not half.twin.face
        if is_apart:
            self._join_faces(half, half.twin.face)
        if half.turned is not half:
            _swap(half, half.turned_back)
            if not is_apart:
                half.fill(half.face.insert())
        if half.twin.turned is half.twin:
            half.twin.face.remove()
        else:
            _swap(half.twin, half.twin.turned_back)

    def _join_faces(self, half: Half, face: Face) -> None:
        half.face.remove()
        half.fill(face)


def _swap(half: Half, other: Half) -> None:
    """Exchange the next ones around the origins of two half-edges."""
    turned, other_turned = half.turned, other.turned
    turned.twin.ahead, other_turned.twin.ahead = other, half
    half.turned, other.turned = other_turned, turned

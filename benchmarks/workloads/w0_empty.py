"""W0: nothing but a background."""


def setup():
    size(640, 480, P2D)


def draw():
    background(200)

"""W1s: 10,000 rectangles, each with a fill of its own and an outline."""


def setup():
    size(640, 480, P2D)
    stroke(0)


def draw():
    background(200)
    for i in range(10000):
        fill(i & 255, (i * 7) & 255, (i * 13) & 255)
        rect((i * 37) % width, (i * 53) % height, 8, 8)

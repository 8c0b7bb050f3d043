"""W6: 10,000 lines, two pixels thick."""


def setup():
    size(640, 480, P2D)
    stroke(0)
    strokeWeight(2)


def draw():
    background(255)
    for i in range(10000):
        x = (i * 37) % width
        y = (i * 53) % height
        line(x, y, x + 24, y + i % 17)

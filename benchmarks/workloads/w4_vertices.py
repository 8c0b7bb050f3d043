"""W4: one shape of 33,333 triangles, vertex by vertex."""


def setup():
    size(640, 480, P2D)
    noStroke()


def draw():
    background(0)
    fill(255, 100, 50)
    beginShape(TRIANGLES)
    for i in range(33333):
        x = (i * 37) % width
        y = (i * 53) % height
        vertex(x, y)
        vertex(x + 4, y)
        vertex(x, y + 4)
    endShape()

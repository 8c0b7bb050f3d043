"""W3s: 1,000 lit boxes with their edges, each with a place, a turn and a fill of its own."""


def setup():
    size(640, 480, P3D)
    stroke(0)


def draw():
    background(0)
    lights()
    for i in range(1000):
        pushMatrix()
        translate((i * 37) % width, (i * 53) % height, -(i % 50))
        rotateX(i * 0.01 + frameCount * 0.01)
        rotateY(i * 0.02)
        fill(i & 255, 200, 100)
        box(12)
        popMatrix()

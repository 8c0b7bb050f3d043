"""W8: 500 lit spheres, each in another fill."""


def setup():
    size(640, 480, P3D)
    noStroke()


def draw():
    background(0)
    lights()
    for i in range(500):
        pushMatrix()
        translate((i * 37) % width, (i * 53) % height, -(i % 50))
        fill(i & 255, 200, 100)
        sphere(20)
        popMatrix()

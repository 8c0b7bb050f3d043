"""Spinning box: a first sketch in three dimensions."""
# check: compare frames=1,30

angle = 0.0


def setup():
    size(640, 480, P3D)


def draw():
    global angle
    background(255)
    lights()
    translate(width / 2, height / 2, 0)
    rotateY(angle)
    rotateX(radians(30))
    fill(200, 80, 40)
    box(120)
    angle += 0.05

"""Spinning box: it turns about its axis, and a click gives it another colour."""
# check: compare frames=1,30

angle = 0.0
is_blue = False


def setup():
    size(320, 240, P3D)


def draw():
    global angle
    background(255)
    lights()
    if is_blue:
        fill(40, 90, 200)
    else:
        fill(200, 80, 40)
    with pushMatrix():
        translate(width / 2, height / 2, 0)
        rotateY(angle)
        rotateX(radians(30))
        box(80)
    angle += 0.05


def mousePressed():
    global is_blue
    is_blue = not is_blue

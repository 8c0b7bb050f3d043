"""Lissajous curves: a table of two swings, one across and one down."""
# check: compare frames=1,30

cell = 90
count = 5


def setup():
    size(540, 540, P2D)
    colorMode(HSB, 360, 100, 100)


def draw():
    background(230, 60, 14)
    phase = frameCount * 0.03
    for i in range(1, count + 1):
        drawKnob(i * cell + cell / 2, cell / 2, i, phase)
        drawKnob(cell / 2, i * cell + cell / 2, i, 0)
        for j in range(1, count + 1):
            drawCurve(i * cell + cell / 2, j * cell + cell / 2, i, j, phase)


def drawCurve(x, y, across, down, phase):
    radius = cell * 0.4
    noFill()
    strokeWeight(2)
    stroke(hueOf(across, down), 65, 95)
    beginShape()
    for step in range(181):
        t = radians(step * 2)
        vertex(x + radius * cos(across * t + phase), y + radius * sin(down * t))
    endShape()


def drawKnob(x, y, speed, phase):
    radius = cell * 0.4
    noFill()
    strokeWeight(1)
    stroke(230, 25, 55)
    circle(x, y, radius * 2)
    noStroke()
    fill(50, 60, 100)
    angle = speed * frameCount * 0.02 + phase
    circle(x + radius * cos(angle), y + radius * sin(angle), 8)


def hueOf(across, down):
    return (across * 47 + down * 23) % 360

"""Tree: a branch is a line with two smaller branches at its end."""
# check: compare frames=1,30


def setup():
    size(640, 480, P2D)


def draw():
    background(238, 232, 213)
    noStroke()
    fill(196, 190, 160)
    rect(0, height - 40, width, 40)
    wind = sin(frameCount * 0.04) * 0.06
    translate(width / 2, height - 40)
    drawBranch(105, 9, wind)


def drawBranch(length, level, wind):
    if level == 0:
        drawLeaf()
        return
    strokeWeight(level * 1.6)
    stroke(lerpColor(color(120, 140, 60), color(70, 45, 30), level / 9))
    line(0, 0, 0, -length)
    translate(0, -length)

    pushMatrix()
    rotate(radians(-22) + wind)
    drawBranch(length * 0.78, level - 1, wind)
    popMatrix()

    pushMatrix()
    rotate(radians(29) + wind)
    drawBranch(length * 0.72, level - 1, wind)
    popMatrix()


def drawLeaf():
    noStroke()
    fill(110, 150, 50, 150)
    ellipse(0, -4, 6, 11)

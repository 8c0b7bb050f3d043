"""Clock: hour(), minute() and second() turn into angles."""
# check: compare frames=1,30


def setup():
    size(420, 420, P2D)
    textAlign(CENTER, CENTER)
    textSize(26)


def draw():
    background(34, 40, 49)
    translate(width / 2, height / 2)
    drawFace()
    drawHand((hour() % 12 + minute() / 60) / 12, 88, 10, color(57, 62, 70))
    drawHand((minute() + second() / 60) / 60, 132, 6, color(57, 62, 70))
    drawHand(second() / 60, 146, 2, color(214, 64, 69))
    noStroke()
    fill(214, 64, 69)
    circle(0, 0, 14)


def drawFace():
    stroke(0, 173, 181)
    strokeWeight(10)
    fill(238, 238, 238)
    circle(0, 0, 360)
    for i in range(60):
        isHour = i % 5 == 0
        angle = TWO_PI * i / 60
        stroke(57, 62, 70)
        strokeWeight(4 if isHour else 1.5)
        inner = 150 if isHour else 158
        line(cos(angle) * inner, sin(angle) * inner, cos(angle) * 166, sin(angle) * 166)
    fill(57, 62, 70)
    for i in range(1, 13):
        angle = TWO_PI * i / 12 - HALF_PI
        text(i, cos(angle) * 126, sin(angle) * 126)


def drawHand(turn, length, thickness, colour):
    """Draw a hand; a turn of 0 points to the 12, of 0.25 to the 3."""
    stroke(colour)
    strokeWeight(thickness)
    pushMatrix()
    rotate(TWO_PI * turn)
    line(0, 18, 0, -length)
    popMatrix()

"""Poster: words as large as the page, and small ones around a circle."""
# check: compare frames=1,30

motto = "lines and letters, numbers and noise, pixels and patience, "


def setup():
    size(420, 594, P2D)


def draw():
    background(242, 100, 60)
    drawRings()
    drawAround(motto * 2, width / 2, 330, 168)

    fill(28, 24, 40)
    textAlign(LEFT, BASELINE)
    for i, word in enumerate(["DRAW", "WITH", "WORDS"]):
        drawFitting(word, 30, 110 + i * 0, i)
    textSize(15)
    textAlign(RIGHT)
    text("a poster of " + str(len(motto.split())) + " words\nset with text()", width - 30, 548)


def drawRings():
    noFill()
    for i in range(9):
        stroke(255, 236, 210, 40 + i * 20)
        strokeWeight(3)
        circle(width / 2, 330, 300 - i * 32 + 6 * sin(frameCount * 0.1 + i))


def drawFitting(word, x, y, i):
    textSize(40)
    textSize(40 * (width - 2 * x) / textWidth(word))
    text(word, x, y)


def drawAround(words, x, y, radius):
    fill(255, 236, 210)
    textSize(18)
    textAlign(CENTER)
    pushMatrix()
    translate(x, y)
    rotate(frameCount * 0.005)
    turned = 0
    for letter in words:
        step = (textWidth(letter) + 1) / radius
        turned += step / 2
        pushMatrix()
        rotate(turned)
        text(letter, 0, -radius)
        popMatrix()
        turned += step / 2
    popMatrix()

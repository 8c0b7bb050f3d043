"""Poster: words as wide as the page, and small letters around a circle."""
# check: compare frames=1,30

margin = 32
motto = "lines and letters, numbers and noise, pixels and patience, "


def setup():
    size(420, 594, P2D)
    textSize(120)


def draw():
    background(242, 100, 60)
    fill(28, 24, 40)
    textAlign(LEFT)
    drawAcross("WORDS", 132)
    drawAcross("CAN TURN", height - margin)

    translate(width / 2, 318)
    drawRings()
    rotate(frameCount * 0.005)
    drawAround(motto * 2, 148)


def drawAcross(word, y):
    """Write a word as large as fits between the margins."""
    textSize(100)
    textSize(100 * (width - 2 * margin) / textWidth(word))
    text(word, margin, y)


def drawRings():
    noFill()
    strokeWeight(3)
    for i in range(8):
        stroke(255, 236, 210, 60 + i * 20)
        circle(0, 0, 264 - i * 32 + 6 * sin(frameCount * 0.1 + i))


def drawAround(words, radius):
    fill(255, 236, 210)
    textAlign(CENTER)
    textSize(16)
    gap = (TWO_PI * radius - textWidth(words)) / len(words)
    for letter in words:
        halfStep = (textWidth(letter) + gap) / radius / 2
        rotate(halfStep)
        text(letter, 0, -radius)
        rotate(halfStep)

"""W11: 1,000 short texts."""


def setup():
    global words
    size(640, 480, P2D)
    textSize(12)
    words = [f"item {i}" for i in range(1000)]


def draw():
    background(255)
    fill(0)
    for i in range(1000):
        text(words[i], (i * 37) % width, (i * 53) % height)

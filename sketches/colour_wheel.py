"""Colour wheel: hue goes around, saturation outwards, and the brightness is the mouse's."""
# check: compare frames=1,30

rings = 6
slices = 36


def setup():
    size(480, 480, P2D)
    colorMode(HSB, 360, 100, 100)
    noStroke()


def draw():
    background(0, 0, 96)
    translate(width / 2, height / 2)
    rotate(frameCount * 0.01)
    brightness = map(mouseX, 0, width, 100, 20)
    for ring in range(rings):
        for slice in range(slices):
            fill(slice * 360 / slices, 100 * (ring + 1) / rings, brightness)
            drawPiece(ring, slice)


def drawPiece(ring, slice):
    inner = 40 + ring * 28
    outer = inner + 24
    start = TWO_PI * slice / slices + 0.02
    stop = TWO_PI * (slice + 1) / slices - 0.02
    beginShape(QUAD_STRIP)
    for step in range(5):
        angle = lerp(start, stop, step / 4)
        vertex(cos(angle) * inner, sin(angle) * inner)
        vertex(cos(angle) * outer, sin(angle) * outer)
    endShape()

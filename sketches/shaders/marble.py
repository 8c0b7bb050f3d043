"""Marble: a vase, and the veins in it are Perlin noise written in GLSL."""
# check: compare frames=1,30

vase = None
marble = None


def setup():
    global vase, marble
    size(560, 420, P3D)
    marble = loadShader("marble.frag", "solid.vert")
    vase = createVase()


def draw():
    background(58, 66, 78)
    pointLight(255, 255, 255, 120, -60, 480)
    translate(width / 2, height / 2)
    rotateX(-0.25)
    rotateY(frameCount * 0.015)
    shader(marble)
    shape(vase)
    resetShader()


def radiusAt(t):
    """Return how wide the vase is, from its mouth (0) to its foot (1)."""
    return 60 + 34 * sin(t * 5.2 - 1.3) - 20 * t + 36 * t**8


def createVase():
    """Return a surface of revolution, with a normal for each vertex."""
    rows, sides = 60, 60
    vase = createShape()
    vase.beginShape(QUADS)
    vase.noStroke()
    for row in range(rows):
        for side in range(sides):
            for down, around in ((0, 0), (0, 1), (1, 1), (1, 0)):
                t = (row + down) / rows
                angle = TWO_PI * (side + around) / sides
                slope = (radiusAt(t + 0.01) - radiusAt(t - 0.01)) / (0.02 * 320)
                r = radiusAt(t)
                vase.normal(cos(angle), -slope, sin(angle))
                vase.vertex(r * cos(angle), 320 * (t - 0.5), r * sin(angle))
    vase.endShape()
    return vase

"""Sphere map: chrome mirrors a whole landscape, which lies in one round picture."""
# check: compare frames=1,30

ring = None
chrome = None


def setup():
    global ring, chrome
    size(560, 420, P3D)
    noStroke()
    chrome = loadShader("sphere_map.frag", "mirror.vert")
    chrome.set("surroundings", createSphereMap(256))
    ring = createRing(110, 42)


def draw():
    background(150, 170, 190)
    shader(chrome)
    translate(width / 2, height / 2)
    rotateX(frameCount * 0.011 + 0.8)
    rotateY(frameCount * 0.02)
    shape(ring)
    sphere(50)
    resetShader()


def createSphereMap(side):
    """Return what a small ball of chrome shows; each pixel is a direction that it reflects to."""
    picture = createImage(side, side, RGB)
    for row in range(side):
        for column in range(side):
            x, y = 2 * (column + 0.5) / side - 1, 2 * (row + 0.5) / side - 1
            z = sqrt(max(0, 1 - x * x - y * y))
            # (0, 0, -1), in which the eye looks, mirrored at the normal (x, y, z):
            picture.set(column, row, landscape(2 * z * x, 2 * z * y, 2 * z * z - 1))
    return picture


def landscape(x, y, z):
    """Return the colour of a direction: sand below the horizon, and a sky with a sun above."""
    if y > 0:
        return lerpColor(color(232, 196, 140), color(88, 58, 40), sqrt(y))
    if PVector(x, y, z).dot(PVector(0.5, -0.6, 0.62)) > 0.97:
        return color(255, 250, 220)
    return lerpColor(color(250, 244, 235), color(28, 82, 160), sqrt(-y))


def createRing(radius, tube):
    ring = createShape()
    ring.beginShape(QUADS)
    ring.noStroke()
    for i in range(60 * 30):
        for around, across in ((0, 0), (1, 0), (1, 1), (0, 1)):
            a, b = TWO_PI * (i // 30 + around) / 60, TWO_PI * (i + across) / 30
            ring.normal(cos(a) * cos(b), sin(a) * cos(b), sin(b))
            r = radius + tube * cos(b)
            ring.vertex(r * cos(a), r * sin(a), tube * sin(b))
    ring.endShape()
    return ring

"""Toon: light in four flat steps and a dark rim, as in a drawn film."""
# check: compare frames=1,30

ring = None
toon = None


def setup():
    global ring, toon
    size(560, 420, P3D)
    noStroke()
    toon = loadShader("toon.frag", "phong.vert")
    ring = createRing(112, 42)


def draw():
    background(255, 236, 179)
    directionalLight(255, 255, 255, 0.6, 0.7, -1)
    shader(toon)
    translate(width / 2, height / 2)
    rotateX(0.9)
    rotateY(frameCount * 0.02)
    shape(ring)
    fill(38, 166, 154)
    sphere(52)
    resetShader()


def createRing(radius, tube):
    """Return a ring around the z-axis, with its normals."""
    ring = createShape()
    ring.beginShape(QUADS)
    ring.noStroke()
    ring.fill(239, 83, 80)
    for i in range(60):
        for j in range(30):
            for around, across in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                a = TWO_PI * around / 60
                b = TWO_PI * across / 30
                ring.normal(cos(a) * cos(b), sin(a) * cos(b), sin(b))
                r = radius + tube * cos(b)
                ring.vertex(r * cos(a), r * sin(a), tube * sin(b))
    ring.endShape()
    return ring

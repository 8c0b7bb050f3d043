"""Morph targets: a face; every vertex knows its place in three expressions, the shader blends."""
# check: compare frames=1,30

face = None
morph = None


def setup():
    global face, morph
    size(560, 420, P3D)
    morph = loadShader("color.frag", "morph.vert")
    face = createFace()


def draw():
    background(255, 214, 102)
    time = frameCount * 0.06
    morph.set("joy", max(0.0, sin(time)))
    morph.set("surprise", max(0.0, sin(time - PI)))
    translate(width / 2, height / 2)
    noStroke()
    fill(246, 150, 96)
    circle(0, 0, 350)
    shader(morph)
    shape(face)
    resetShader()


def createFace():
    face = createShape()
    face.beginShape(QUADS)
    face.noStroke()
    for side in (-1, 1):
        face.fill(255)
        addFeature(face, lambda u, v, mood: eye(u, v, mood, side, 34))
        face.fill(50, 40, 60)
        addFeature(face, lambda u, v, mood: eye(u, v, mood, side, 14))
        addFeature(face, lambda u, v, mood: brow(u, v, mood, side))
    face.fill(130, 30, 50)
    addFeature(face, mouth)
    face.endShape()
    return face


def addFeature(face, placeOf):
    """Add a strip of quads; `placeOf` says where u and v, from -1 to 1, lie in a mood."""
    steps = 24
    for i in range(steps):
        for right, v in ((0, -1), (1, -1), (1, 1), (0, 1)):
            u = 2 * (i + right) / steps - 1
            x, y = placeOf(u, v, "joy")
            face.attribPosition("joyPlace", x, y, 2)
            x, y = placeOf(u, v, "surprise")
            face.attribPosition("surprisePlace", x, y, 2)
            x, y = placeOf(u, v, "calm")
            face.vertex(x, y, 2)


def eye(u, v, mood, side, radius):
    opened = {"calm": 0.8, "joy": 0.55, "surprise": 1.25}[mood]
    return side * 62 + radius * u, -45 + v * radius * opened * sqrt(1 - u * u)


def brow(u, v, mood, side):
    y, bend = {"calm": (-98, 6), "joy": (-104, 14), "surprise": (-128, 20)}[mood]
    return side * 62 + 40 * u, y + bend * u * u + 5 * v


def mouth(u, v, mood):
    wide, bend, opened = {"calm": (62, -4, 5), "joy": (96, -52, 22), "surprise": (34, 0, 40)}[mood]
    return wide * u, 78 - bend * 0.4 + bend * u * u + v * opened * sqrt(1 - u * u)

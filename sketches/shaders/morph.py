"""Morph targets: a face in three moods; each vertex knows its places in all, the shader blends."""
# check: compare frames=1,30

# Calm, glad and surprised: middle (x, y), half the width, how it bends, half the height.
eye = ((62, -45, 34, 0, 27), (62, -45, 34, 0, 19), (62, -45, 34, 0, 42))
pupil = ((62, -45, 14, 0, 11), (62, -45, 14, 0, 8), (62, -45, 14, 0, 18))
brow = ((62, -98, 40, 6, 6), (62, -104, 40, 14, 6), (62, -128, 40, 20, 6))
mouth = ((0, 80, 62, -4, 5), (0, 99, 96, -52, 22), (0, 78, 34, 0, 40))
face, morph = None, None


def setup():
    global face, morph
    size(560, 420, P3D)
    noStroke()
    fill(246, 150, 96)
    morph = loadShader("color.frag", "morph.vert")
    face = createFace()


def draw():
    background(255, 214, 102)
    time = frameCount * 0.06
    morph.set("joy", max(0.0, sin(time)))
    morph.set("surprise", max(0.0, sin(time - PI)))
    translate(width / 2, height / 2)
    circle(0, 0, 350)
    shader(morph)
    shape(face)
    resetShader()


def createFace():
    face = createShape()
    face.beginShape(QUADS)
    face.noStroke()
    for moods, tone in ((eye, "#FFFFFF"), (pupil, "#32283C"), (brow, "#32283C")):
        face.fill(tone)
        addFeature(face, moods, -1)
        addFeature(face, moods, 1)
    face.fill("#821E32")
    addFeature(face, mouth, 1)
    face.endShape()
    return face


def addFeature(face, moods, side):
    """Add a strip of quads; u and v run from -1 to 1 along it and across."""
    for i in range(24):
        for right, v in ((0, -1), (1, -1), (1, 1), (0, 1)):
            u = (i + right) / 12 - 1
            calm, joy, surprise = [placeOf(mood, side, u, v) for mood in moods]
            face.attribPosition("joyPlace", joy.x, joy.y, 2)
            face.attribPosition("surprisePlace", surprise.x, surprise.y, 2)
            face.vertex(calm.x, calm.y, 2)


def placeOf(mood, side, u, v):
    x, y, wide, bend, high = mood
    return PVector(side * x + wide * u, y + bend * u * u + high * v * sqrt(1 - u * u))

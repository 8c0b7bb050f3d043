"""Stripes: the fragment shader asks each pixel where on the solid it lies."""
# check: compare frames=1,30

solids = []
stripes = None


def setup():
    global stripes
    size(560, 420, P3D)
    stripes = loadShader("stripes.frag", "stripes.vert")
    noStroke()
    # A PShape keeps its own coordinates, so that its stripes turn with it. What is drawn at once,
    # by sphere() or box(), reaches the shader as it lies before the eye.
    solids.append(createShape(SPHERE, 92))
    solids.append(createShape(BOX, 128))


def draw():
    background(250, 244, 232)
    stripes.set("shift", frameCount * 0.01)
    shader(stripes)
    for i, solid in enumerate(solids):
        pushMatrix()
        translate(width * (0.27 + 0.46 * i), height / 2)
        rotateX(0.5 - i)
        rotateY(0.4 + frameCount * 0.015)
        fill(255)
        shape(solid)
        popMatrix()
    resetShader()

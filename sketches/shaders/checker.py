"""Checker: cubes of two colours that fill space; a solid shows those it is cut out of."""
# check: compare frames=1,30

solids = []
checker = None


def setup():
    global checker
    size(560, 420, P3D)
    noStroke()
    sphereDetail(48)
    checker = loadShader("checker.frag", "solid.vert")
    checker.set("light", 0.98, 0.95, 0.88)
    checker.set("dark", 0.20, 0.36, 0.44)
    checker.set("cube", 32.0)
    solids.append(createShape(SPHERE, 96))
    solids.append(createShape(BOX, 128))


def draw():
    background(236, 200, 150)
    pointLight(255, 255, 255, width / 2, -100, 500)
    shader(checker)
    for i, solid in enumerate(solids):
        pushMatrix()
        translate(width * (0.28 + 0.44 * i), height / 2)
        rotateX(-0.5)
        rotateY(frameCount * 0.015 + 0.6)
        shape(solid)
        popMatrix()
    resetShader()

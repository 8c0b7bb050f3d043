"""Skinning: an arm of one skin bends with its bones; the vertex shader blends their transforms."""
# check: compare frames=1,30

bones = 4
boneLength = 84
skin, arm = None, None


def setup():
    global skin, arm
    size(560, 420, P3D)
    skin = loadShader("color.frag", "skin.vert")
    arm = createArm(48, 24)


def draw():
    background(22, 58, 82)
    pointLight(255, 255, 255, 80, -80, 500)
    setPose(frameCount * 0.05)
    translate(width / 2, height * 0.96)
    rotateY(0.5)
    shader(skin)
    shape(arm)
    resetShader()


def setPose(time):
    """Hand the transforms of the bones to the shader: each starts where the last one ends."""
    pose = PMatrix3D()
    for bone in range(bones):
        pose.translate(0, -bone * boneLength, 0)
        pose.rotateZ(0.5 * sin(time + 1 - bone * 0.8))
        pose.translate(0, bone * boneLength, 0)
        columns = pose.get()
        columns.transpose()  # set() gives a PMatrix3D's rows to GLSL as columns
        skin.set(f"Transforms[{bone}]", columns)


def createArm(rings, sides):
    """Return the arm in its bind pose, straight up: quads between rings around the y-axis."""
    arm = createShape()
    arm.beginShape(QUADS)
    arm.noStroke()
    for ring in range(rings):
        arm.fill("#FACD8C" if ring % 8 < 4 else "#F0785A")
        for side in range(sides):
            for up, around in ((0, 0), (0, 1), (1, 1), (1, 0)):
                addVertex(arm, (ring + up) / rings, TWO_PI * (side + around) / sides)
    arm.endShape()
    return arm


def addVertex(arm, along, angle):
    """Add a vertex with its two nearest bones, and how much each of them moves it."""
    place = constrain(along * bones - 0.5, 0, bones - 1)  # 1.25: mostly bone 1, a quarter bone 2
    arm.attrib("MatrixIndices", floor(place), ceil(place), 0, 0)
    arm.attrib("Weights", 1 - place % 1, place % 1, 0, 0)
    radius = 40 * sqrt(max(0, 1 - along**3))
    arm.normal(cos(angle), -0.4 * along, sin(angle))
    arm.vertex(radius * cos(angle), -along * bones * boneLength, radius * sin(angle))

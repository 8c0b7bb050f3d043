"""Skinning: an arm of one skin bends with its bones; the vertex shader blends their transforms."""
# check: compare frames=1,30

bones = 4
boneLength = 74
rings = 48
skin = None
arm = None


def setup():
    global skin, arm
    size(560, 420, P3D)
    skin = loadShader("color.frag", "skin.vert")
    arm = createArm()


def draw():
    background(22, 58, 82)
    pointLight(255, 255, 255, 80, -80, 500)
    setPose(frameCount * 0.05)
    translate(width / 2, height * 0.95)
    rotateY(0.5)
    shader(skin)
    shape(arm)
    resetShader()


def setPose(time):
    """Hand the transforms of the bones to the shader: each starts where the last one ends."""
    pose = PMatrix3D()
    for bone in range(bones):
        pose.translate(0, -bone * boneLength, 0)
        pose.rotateZ(0.42 * sin(time - bone * 0.9))
        pose.rotateX(0.25 * cos(time * 0.7 - bone))
        pose.translate(0, bone * boneLength, 0)
        columns = pose.get()
        columns.transpose()  # a PMatrix3D arrives with its rows where GLSL has columns
        skin.set("Transforms[" + str(bone) + "]", columns)


def createArm():
    """Return the arm in its bind pose, straight up: QUADS between rings around the y-axis."""
    arm = createShape()
    arm.beginShape(QUADS)
    arm.noStroke()
    for ring in range(rings):
        arm.fill(lerpColor(color(240, 120, 90), color(250, 205, 140), ring % 8 // 4))
        for side in range(24):
            for up, around in ((0, 0), (0, 1), (1, 1), (1, 0)):
                addVertex(arm, (ring + up) / rings, TWO_PI * (side + around) / 24)
    arm.endShape()
    return arm


def addVertex(arm, along, angle):
    """Add a vertex with its two nearest bones and how much each of them moves it."""
    place = constrain(along * bones - 0.5, 0, bones - 1)  # 1.25: between bones 1 and 2
    first = min(int(place), bones - 2)
    arm.attrib("MatrixIndices", first, first + 1.0, 0.0, 0.0)
    arm.attrib("Weights", 1 - (place - first), place - first, 0.0, 0.0)
    radius = 40 * sqrt(max(0, 1 - along**3))
    arm.normal(cos(angle), -0.4 * along, sin(angle))
    arm.vertex(radius * cos(angle), -along * bones * boneLength, radius * sin(angle))

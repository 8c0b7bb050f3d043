"""Wood: rings around the axis of a trunk, in which three things are carved."""
# check: compare frames=1,30

blocks = []
wood = None


def setup():
    global wood
    size(560, 420, P3D)
    noStroke()
    sphereDetail(48)
    wood = loadShader("wood.frag", "solid.vert")
    blocks.append(createShape(BOX, 330, 26, 150))
    blocks.append(createShape(SPHERE, 62))
    blocks.append(createShape(BOX, 90))


def draw():
    background(70, 92, 84)
    pointLight(255, 250, 235, 100, -250, 500)
    shader(wood)
    translate(width / 2, height * 0.57)
    rotateX(-0.4)
    rotateY(0.35 + frameCount * 0.01)
    carve(blocks[0], 0, 0, 0)
    carve(blocks[1], -85, -75, 0)
    carve(blocks[2], 80, -58, 0)
    resetShader()


def carve(block, x, y, z):
    """Draw a block; the trunk lies along its x-axis, a little below it."""
    pushMatrix()
    translate(x, y, z)
    shape(block)
    popMatrix()

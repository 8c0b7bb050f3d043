"""Table and lamp: objects with a place, a turn and a size, which take their parts along."""
# check: compare frames=1,30


class GraphicsObject:
    """A shape, or none, where it stands in its parent; and what stands on it."""

    def __init__(self, shape=None):
        self.shape = shape
        self.position = PVector(0, 0, 0)
        self.rotation = PVector(0, 0, 0)
        self.scale = PVector(1, 1, 1)
        self.children = []

    def add(self, child, x, y, z):
        child.position.set(x, y, z)
        self.children.append(child)
        return child

    def display(self):
        with pushMatrix():
            translate(self.position.x, self.position.y, self.position.z)
            rotateX(self.rotation.x)
            rotateY(self.rotation.y)
            rotateZ(self.rotation.z)
            scale(self.scale.x, self.scale.y, self.scale.z)
            if self.shape is not None:
                shape(self.shape)
            for child in self.children:
                child.display()


def setup():
    global table, arm, elbow
    size(480, 400, P3D)
    noStroke()
    fill("#A9714B")
    top, leg = createShape(BOX, 220, 10, 130), createShape(BOX, 12, 110, 12)
    fill("#3D5A80")
    rod, foot = createShape(BOX, 7, 76, 7), createShape(BOX, 44, 6, 44)
    fill("#EE6C4D")
    hood = createHood(8, 26, 36)
    fill("#98C1D9")
    ball = createShape(SPHERE, 17)

    # Four legs, but one shape: it is only drawn in four places.
    table = GraphicsObject(top)
    for x in (-98, 98):
        for z in (-54, 54):
            table.add(GraphicsObject(leg), x, 60, z)
    table.add(GraphicsObject(ball), 62, -22, 22)
    lamp = table.add(GraphicsObject(foot), -60, -8, -10)
    arm = lamp.add(GraphicsObject(), 0, -3, 0)
    arm.add(GraphicsObject(rod), 0, -38, 0)
    elbow = arm.add(GraphicsObject(), 0, -74, 0)
    elbow.scale.set(0.8, 0.8, 0.8)
    elbow.add(GraphicsObject(rod), 0, -36, 0)
    shade = elbow.add(GraphicsObject(hood), 0, -76, 0)
    shade.rotation.z = -1.6


def createHood(top, bottom, length):
    """A cone without its tip, open at both ends."""
    hood = createShape()
    with hood.beginShape(QUAD_STRIP):
        for i in range(25):
            x, z = cos(TWO_PI * i / 24), sin(TWO_PI * i / 24)
            hood.normal(x, -0.5, z)
            hood.vertex(top * x, 0, top * z)
            hood.vertex(bottom * x, length, bottom * z)
    return hood


def draw():
    background(233, 236, 239)
    ambientLight(110, 110, 120)
    directionalLight(180, 175, 165, 0.4, 1, -0.7)
    table.position.set(width / 2, height * 0.55, -20)
    table.rotation.set(-0.35, 0.5 + frameCount * 0.01, 0)
    arm.rotation.z = -0.3 + 0.2 * sin(frameCount * 0.05)
    elbow.rotation.z = 1.4 - 0.4 * sin(frameCount * 0.04)
    table.display()

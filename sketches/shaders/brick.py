"""Brick: walls of a tower out of two numbers, the length and the height of a brick."""
# check: compare frames=1,30

tower = None
merlon = None
brick = None


def setup():
    global tower, merlon, brick
    size(560, 420, P3D)
    noStroke()
    brick = loadShader("brick.frag", "solid.vert")
    brick.set("brick", 30.0, 13.0)
    brick.set("joint", 2.5)
    tower = createShape(BOX, 120, 220, 120)
    merlon = createShape(BOX, 30, 34, 30)


def draw():
    background(150, 190, 215)
    pointLight(255, 245, 225, 60, -150, 600)
    translate(width / 2, height * 0.58)
    rotateX(-0.4)
    rotateY(0.6 + frameCount * 0.01)
    shader(brick)
    shape(tower)
    for x in (-45, 0, 45):
        for z in (-45, 0, 45):
            if x or z:
                pushMatrix()
                translate(x, -127, z)
                shape(merlon)
                popMatrix()
    resetShader()

"""Texture: a picture under water; the fragment shader bends where it looks."""
# check: compare frames=1,30

picture = None
water = None


def setup():
    global picture, water
    size(560, 420, P3D)
    noStroke()
    textureMode(NORMAL)
    picture = createPond(256)
    water = loadShader("water.frag", "texture.vert")


def draw():
    background(226, 232, 220)
    water.set("time", frameCount / 20.0)
    shader(water)
    translate(width / 2, height * 0.46)
    rotateX(0.7)
    rotateZ(0.12)
    beginShape(QUADS)
    texture(picture)  # the shader finds it as `texture`
    for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
        vertex(330 * (x - 0.5), 330 * (y - 0.5), x, y)
    endShape()
    resetShader()


def createPond(side):
    """Return a picture of tiles and three fish."""
    pond = createGraphics(side, side, P2D)
    pond.beginDraw()
    pond.background(40, 130, 150)
    pond.stroke(90, 185, 195)
    pond.strokeWeight(3)
    for i in range(9):
        pond.line(i * side / 8, 0, i * side / 8, side)
        pond.line(0, i * side / 8, side, i * side / 8)
    pond.noStroke()
    for x, y, turn in ((70, 80, 0.4), (180, 110, 2.6), (110, 195, -0.5)):
        pond.pushMatrix()
        pond.translate(x, y)
        pond.rotate(turn)
        pond.fill(250, 130, 50)
        pond.ellipse(0, 0, 74, 34)
        pond.triangle(-30, 0, -56, -20, -56, 20)
        pond.fill(255, 240, 220)
        pond.ellipse(6, 2, 26, 20)
        pond.popMatrix()
    pond.endDraw()
    return pond

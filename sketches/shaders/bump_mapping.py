"""Bump mapping: an orange is a smooth ball; a picture of heights bends its normals."""
# check: compare frames=1,30

orange = None
smooth = None
bumpy = None


def setup():
    global orange, smooth, bumpy
    size(560, 420, P3D)
    noStroke()
    sphereDetail(48)
    orange = createShape(SPHERE, 104)
    orange.setTexture(createPores(512, 256))
    smooth = loadShader("bump.frag", "surface.vert")
    smooth.set("depth", 0.0)
    bumpy = loadShader("bump.frag", "surface.vert")
    bumpy.set("depth", 1.8)


def draw():
    background(52, 94, 104)
    pointLight(255, 255, 255, width / 2, -60, 420)
    for across, skin in ((0.27, smooth), (0.73, bumpy)):
        pushMatrix()
        translate(width * across, height / 2)
        rotateX(0.5)
        rotateY(frameCount * 0.012)
        shader(skin)
        shape(orange)
        popMatrix()
    resetShader()


def createPores(columns, rows):
    """Return a picture of heights: white, with pores that are dark in their middle."""
    picture = createGraphics(columns, rows, P2D)
    picture.beginDraw()
    picture.background(255)
    picture.noStroke()
    for i in range(1500):
        y = random(rows)
        stretch = 1 / max(0.2, sin(PI * y / rows))  # near the poles the picture is squeezed
        x = random(columns)
        for dark in range(5):
            picture.fill(255 - 40 * dark)
            picture.ellipse(x, y, (5 - dark) * 1.6 * stretch, (5 - dark) * 1.6)
    picture.endDraw()
    return picture

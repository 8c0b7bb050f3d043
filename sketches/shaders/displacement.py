"""Displacement: an island; the vertex shader lifts a flat grid by a picture of heights."""
# check: compare frames=1,30

cells = 100
side = 380
grid = None
lift = None


def setup():
    global grid, lift
    size(560, 420, P3D)
    lift = loadShader("color.frag", "displace.vert")
    lift.set("heights", createHeights(128))
    lift.set("side", float(side))
    grid = createGrid()


def draw():
    background(205, 226, 236)
    lift.set("top", 130.0 * min(1.0, frameCount / 40.0))  # it rises out of the sea
    translate(width / 2, height * 0.56, -90)
    rotateX(-0.55)
    rotateY(frameCount * 0.008)
    shader(lift)
    shape(grid)
    resetShader()


def createGrid():
    """Return a flat square of quads; y is 0 everywhere."""
    grid = createShape()
    grid.beginShape(QUADS)
    grid.noStroke()
    cell = side / cells
    for i in range(cells):
        for j in range(cells):
            for right, deep in ((0, 0), (1, 0), (1, 1), (0, 1)):
                grid.vertex((i + right) * cell - side / 2, 0, (j + deep) * cell - side / 2)
    grid.endShape()
    return grid


def createHeights(pixels):
    """Return a picture of heights: noise, and lower towards the edges."""
    picture = createImage(pixels, pixels, RGB)
    picture.loadPixels()
    noiseDetail(5, 0.5)
    for y in range(pixels):
        for x in range(pixels):
            away = dist(x, y, pixels / 2, pixels / 2) / (pixels / 2)
            height = 1.75 * noise(x * 0.03, y * 0.03) - 0.05 - 0.7 * away * away
            picture.pixels[y * pixels + x] = color(255 * constrain(height, 0, 1))
    picture.updatePixels()
    return picture

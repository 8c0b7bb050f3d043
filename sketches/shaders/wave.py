"""Wave: a flag that the vertex shader moves; the sketch draws the same flat cloth each time."""
# check: compare frames=1,30

columns = 60
rows = 24
cell = 6
cloth = None
wave = None


def setup():
    global cloth, wave
    size(560, 420, P3D)
    wave = loadShader("color.frag", "wave.vert")
    wave.set("cloth", float(columns * cell))
    cloth = createCloth()


def draw():
    background(196, 222, 238)
    translate(100, 90)
    drawPole()
    rotateY(-0.35)
    wave.set("time", frameCount / 15.0)
    shader(wave)
    shape(cloth)
    resetShader()


def createCloth():
    """Return a flat grid in the xy-plane: only a grid of many vertices can be bent."""
    grid = createShape()
    grid.beginShape(QUADS)
    grid.noStroke()
    for row in range(rows):
        for column in range(columns):
            grid.fill(colourOf(column, row))
            for right, down in ((0, 0), (1, 0), (1, 1), (0, 1)):
                grid.vertex((column + right) * cell, (row + down) * cell)
    grid.endShape()
    return grid


def colourOf(column, row):
    """Return the colour of a cell: a sun on three stripes."""
    if dist(column + 0.5, row + 0.5, 18, rows / 2) < 7:
        return color(255, 205, 60)
    return [color(20, 90, 150), color(240, 244, 246), color(190, 50, 60)][row // 8]


def drawPole():
    noStroke()
    fill(110, 84, 62)
    rect(-9, -16, 9, 346)
    fill(230, 190, 80)
    circle(-4, -20, 18)

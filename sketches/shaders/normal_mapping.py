"""Normal mapping: a flat wall of stones; a picture says where each of its pixels looks to."""
# check: compare frames=1,30

stones = None
wall = None


def setup():
    global stones, wall
    size(560, 420, P3D)
    noStroke()
    textureMode(NORMAL)
    stones = createStones(160, 120, 20)
    wall = loadShader("normals.frag", "normals.vert")
    wall.set("normals", createNormals(stones))  # a second picture, by a name of our own


def draw():
    background(20)
    angle = frameCount * 0.05
    pointLight(255, 236, 200, width * (0.5 + 0.3 * cos(angle)), height * (0.5 + 0.3 * sin(angle)), 90)
    shader(wall)
    beginShape(QUADS)
    texture(stones)
    normal(0, 0, 1)
    attribNormal("tangent", 1, 0, 0)  # where the right of the picture lies on the wall
    for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
        vertex(width * x, height * y, 0, x, y)
    endShape()
    resetShader()


def createStones(columns, rows, cell):
    """Return heights: a pixel is the higher, the more it is nearest to one stone's middle alone."""
    shifts = [(random(cell), random(cell)) for i in range(columns * rows // cell**2)]
    picture = createImage(columns, rows, RGB)
    for y in range(rows):
        for x in range(columns):
            gaps = []
            for i in range(x // cell - 1, x // cell + 2):
                for j in range(y // cell - 1, y // cell + 2):
                    right, down = shifts[i % (columns // cell) + j % (rows // cell) * (columns // cell)]
                    gaps.append(dist(x, y, i * cell + right, j * cell + down))
            near, second = sorted(gaps)[:2]
            picture.set(x, y, color(70 + 150 * min(1, (second - near) / 9) + random(12)))
    return picture


def createNormals(heights):
    """Return a picture of the normals: red, green and blue are x, y and z, from -1 to 1."""
    columns, rows = heights.width, heights.height
    picture = createImage(columns, rows, RGB)
    for y in range(rows):
        for x in range(columns):
            rightRise = red(heights.get((x + 1) % columns, y)) - red(heights.get(x - 1, y))
            downRise = red(heights.get(x, (y + 1) % rows)) - red(heights.get(x, y - 1))
            n = PVector(-rightRise, -downRise, 70).normalize()
            picture.set(x, y, color(128 + 127 * n.x, 128 + 127 * n.y, 128 + 127 * n.z))
    return picture

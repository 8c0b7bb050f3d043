"""Normal mapping: a flat wall of stones; a picture says where each of its pixels looks to."""
# check: compare frames=1,30

stones = None
wall = None


def setup():
    global stones, wall
    size(560, 420, P3D)
    noStroke()
    textureMode(NORMAL)
    stones = createStones(8, 6, 20)
    wall = loadShader("normals.frag", "normals.vert")
    wall.set("normals", createNormals(stones))  # a second picture, by a name of our own


def draw():
    background(20)
    angle = frameCount * 0.05
    lampX, lampY = width / 2 + 170 * cos(angle), height / 2 + 120 * sin(angle)
    pointLight(255, 236, 200, lampX, lampY, 90)
    shader(wall)
    beginShape(QUADS)
    texture(stones)
    normal(0, 0, 1)
    attribNormal("tangent", 1, 0, 0)  # where the right of the picture lies on the wall
    for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
        vertex(width * x, height * y, 0, x, y)
    endShape()
    resetShader()


def createStones(across, down, cell):
    """Return heights: a stone lies in each cell of a grid, and is low where the next one begins."""
    middles = {(i, j): (random(cell), random(cell)) for i in range(across) for j in range(down)}
    picture = createImage(across * cell, down * cell, RGB)
    for y in range(picture.height):
        for x in range(picture.width):
            gaps = []
            for i in range(x // cell - 1, x // cell + 2):
                for j in range(y // cell - 1, y // cell + 2):
                    shift = middles[i % across, j % down]  # %: the edges fit together
                    gaps.append(dist(x, y, i * cell + shift[0], j * cell + shift[1]))
            near, second = sorted(gaps)[:2]
            picture.set(x, y, color(70 + 150 * min(1, (second - near) / 9) + random(12)))
    return picture


def createNormals(heights):
    """Return a picture of the normals: red, green and blue are x, y and z, from -1 to 1."""
    columns, rows = heights.width, heights.height
    picture = createImage(columns, rows, RGB)
    for y in range(rows):
        for x in range(columns):
            left, right = heights.get((x - 1) % columns, y), heights.get((x + 1) % columns, y)
            above, below = heights.get(x, (y - 1) % rows), heights.get(x, (y + 1) % rows)
            n = PVector(red(left) - red(right), red(above) - red(below), 70).normalize()
            picture.set(x, y, color(128 + 127 * n.x, 128 + 127 * n.y, 128 + 127 * n.z))
    return picture

"""Textured cube: the picture on its faces is made pixel by pixel, too."""
# check: compare frames=1,30

# For each face its normal, and where its picture's right and lower edges point to.
faces = [
    ((0, 0, 1), (1, 0, 0), (0, 1, 0)),
    ((0, 0, -1), (-1, 0, 0), (0, 1, 0)),
    ((1, 0, 0), (0, 0, -1), (0, 1, 0)),
    ((-1, 0, 0), (0, 0, 1), (0, 1, 0)),
    ((0, 1, 0), (1, 0, 0), (0, 0, -1)),
    ((0, -1, 0), (1, 0, 0), (0, 0, 1)),
]
tile = None


def setup():
    global tile
    size(480, 480, P3D)
    noStroke()
    textureMode(NORMAL)
    tile = createTile(128)


def createTile(side):
    """Rings of colour around the middle, and a frame."""
    picture = createImage(side, side, RGB)
    picture.loadPixels()
    for y in range(side):
        for x in range(side):
            rings = dist(x, y, side / 2, side / 2) / side
            shade = color(250 - 200 * rings, 170 + 80 * sin(rings * 40), 60 + 240 * rings)
            if min(x, y, side - 1 - x, side - 1 - y) < 5:
                shade = color(40, 30, 60)
            picture.pixels[y * side + x] = shade
    picture.updatePixels()
    return picture


def draw():
    background(245, 240, 230)
    lights()
    translate(width / 2, height / 2)
    rotateX(radians(-25))
    rotateY(frameCount * 0.02 + 0.5)
    scale(95)
    beginShape(QUADS)
    texture(tile)
    for out, right, down in faces:
        normal(out[0], out[1], out[2])
        for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
            corner = [out[i] + (2 * u - 1) * right[i] + (2 * v - 1) * down[i] for i in range(3)]
            vertex(corner[0], corner[1], corner[2], u, v)
    endShape()

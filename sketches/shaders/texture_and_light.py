"""Texture and light: a planet, whose picture the light makes bright or dark."""
# check: compare frames=1,30

planet = None
shade = None


def setup():
    global planet, shade
    size(560, 420, P3D)
    noStroke()
    sphereDetail(48)
    planet = createShape(SPHERE, 140)
    planet.setTexture(createClouds(256, 128))
    shade = loadShader("texlight.frag", "texlight.vert")


def draw():
    background(10, 10, 22)
    drawStars()
    pointLight(255, 255, 255, -100, 20, 420)
    shader(shade)
    translate(width / 2, height / 2)
    rotateZ(0.3)
    rotateY(frameCount * 0.01)
    shape(planet)
    resetShader()


def drawStars():
    randomSeed(4)
    for i in range(120):
        fill(random(80, 255))
        rect(random(width), random(height), 2, 2)


def createClouds(columns, rows):
    """Return bands of cloud; their edges are frayed by noise()."""
    bands = ["#F0D9B5", "#A8643C", "#F3E2C4", "#C98F5E", "#8F5A3A", "#F5E6CE", "#B9714A"]
    picture = createImage(columns, rows, RGB)
    picture.loadPixels()
    for y in range(rows):
        for x in range(columns):
            # noise() is taken around a circle, so that left and right edge fit together.
            angle = TWO_PI * x / columns
            frayed = noise(2 + cos(angle) * 1.5, 2 + sin(angle) * 1.5, y * 0.06)
            band = y / rows * 12 + 2 * frayed
            first, second = bands[int(band) % 7], bands[int(band + 1) % 7]
            picture.pixels[y * columns + x] = lerpColor(color(first), color(second), band % 1)
    picture.updatePixels()
    return picture

"""Gouraud and Phong: eight lights, worked out at the vertices and at the pixels."""
# check: compare frames=1,30

gouraud = None
phong = None
hues = ["#FF6B5A", "#FFB347", "#FFF275", "#7BE495", "#56C5E8", "#6A7BFF", "#C77DFF", "#FF70B8"]


def setup():
    global gouraud, phong
    size(560, 420, P3D)
    noStroke()
    textAlign(CENTER)
    textSize(18)
    sphereDetail(16)  # coarse, so that the difference shows
    gouraud = loadShader("color.frag", "gouraud.vert")
    phong = loadShader("phong.frag", "phong.vert")


def draw():
    background(18, 18, 26)
    drawBall(0.26, gouraud, "Gouraud")
    drawBall(0.74, phong, "Phong")


def drawBall(across, shade, title):
    pushMatrix()
    translate(width * across, height * 0.44)
    for i, hue in enumerate(hues):
        pointLight(red(hue), green(hue), blue(hue), lampX(i), lampY(i), 120)
    shader(shade)
    fill(150)
    sphere(86)
    resetShader()
    noLights()  # these eight are not for the other ball
    for i, hue in enumerate(hues):
        fill(hue)
        circle(lampX(i), lampY(i), 9)
    fill(220)
    text(title, 0, 184)
    popMatrix()


def lampX(i):
    return 112 * cos(TWO_PI * i / 8 + frameCount * 0.01)


def lampY(i):
    return 112 * sin(TWO_PI * i / 8 + frameCount * 0.01)

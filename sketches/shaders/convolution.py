"""Convolution: four filters of nine numbers each; filter() runs a shader over a picture."""
# check: compare frames=1,30

kernels = {
    "as it is": [0, 0, 0, 0, 1, 0, 0, 0, 0],
    "blur": [1 / 16, 2 / 16, 1 / 16, 2 / 16, 4 / 16, 2 / 16, 1 / 16, 2 / 16, 1 / 16],
    "sharpen": [0, -1, 0, -1, 5, -1, 0, -1, 0],
    "edges": [-1, -1, -1, -1, 8, -1, -1, -1, -1],
}
shaders = []
street = None


def setup():
    global street
    size(560, 420, P2D)
    noStroke()
    street = createGraphics(width // 2, height // 2, P2D)
    for kernel in kernels.values():
        convolve = loadShader("convolve.frag")
        convolve.set("kernel", [float(number) for number in kernel])
        shaders.append(convolve)


def draw():
    for i, title in enumerate(kernels):
        drawStreet(frameCount * 0.4)
        for times in range(4 if title == "blur" else 1):
            street.filter(shaders[i])
        x, y = i % 2 * width // 2, i // 2 * height // 2
        image(street, x, y)
        fill(0, 150)
        rect(x, y, 76, 24)
        fill(255)
        text(title, x + 8, y + 17)


def drawStreet(time):
    """Draw houses at night."""
    randomSeed(7)
    street.beginDraw()
    street.background(44, 40, 92)
    street.noStroke()
    street.fill(255, 240, 200)
    street.circle(210 - time, 46, 44)
    for house in range(9):
        x, top = house * 34 - 12, random(60, 130)
        street.fill(random(60, 160), random(50, 90), random(80, 130))
        street.rect(x, top, 34, 210 - top)
        street.fill(255, 205, 100)
        for row in range(int((190 - top) / 22)):
            street.rect(x + 6, top + 12 + 22 * row, 8, 11)
            street.rect(x + 20, top + 12 + 22 * row, 8, 11)
    street.endDraw()

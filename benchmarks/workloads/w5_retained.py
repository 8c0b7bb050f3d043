"""W5: one shape that is kept, of 1,000,000 triangles."""


def setup():
    global big
    size(640, 480, P3D)
    big = createShape()
    big.beginShape(TRIANGLES)
    big.noStroke()
    for i in range(1000):
        for j in range(500):
            x = i * 0.4 - 200
            y = j * 0.8 - 200
            z = 20 * sin(i * 0.05) * cos(j * 0.05)
            big.fill(i & 255, j & 255, 128)
            big.vertex(x, y, z)
            big.vertex(x + 0.4, y, z)
            big.vertex(x, y + 0.8, z)
            big.vertex(x + 0.4, y, z)
            big.vertex(x + 0.4, y + 0.8, z)
            big.vertex(x, y + 0.8, z)
    big.endShape()


def draw():
    background(0)
    translate(width / 2, height / 2)
    rotateY(frameCount * 0.01)
    rotateX(frameCount * 0.013)
    shape(big)

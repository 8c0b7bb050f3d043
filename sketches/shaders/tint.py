"""Tint: one drawing four times, its colours multiplied by a uniform of the shader."""
# check: compare frames=1,30

tints = [(1.0, 1.0, 1.0), (1.0, 0.75, 0.4), (0.35, 0.9, 1.0), (1.0, 0.45, 0.65)]
shaders = []


def setup():
    size(560, 420, P3D)
    noStroke()
    for red, green, blue in tints:
        shade = loadShader("tint.frag", "color.vert")
        shade.set("tint", red, green, blue)  # a vec3 takes three numbers
        shaders.append(shade)


def draw():
    background(24, 26, 38)
    for i, shade in enumerate(shaders):
        shader(shade)
        pushMatrix()
        translate(width * (0.27 + 0.46 * (i % 2)), height * (0.26 + 0.48 * (i // 2)))
        rotate(frameCount * 0.01 * (1 if i in (0, 3) else -1))
        drawFlower()
        popMatrix()
    resetShader()


def drawFlower():
    """Draw petals whose corners have colours of their own, from white to violet."""
    for petal in range(12):
        pushMatrix()
        rotate(TWO_PI * petal / 12)
        beginShape(TRIANGLES)
        for side in (-1, 1):
            fill(255)
            vertex(22, 0)
            fill(205, 190, 235)
            vertex(58, side * 17)
            fill(95, 70, 160)
            vertex(94, 0)
        endShape()
        popMatrix()
    fill(250, 235, 180)
    circle(0, 0, 34)

"""Terrain: strips of triangles, as high as noise() says, seen from a plane."""
# check: compare frames=1,30

cell = 20
columns = 60
rows = 45


def setup():
    size(640, 400, P3D)
    noStroke()


def draw():
    background(190, 214, 232)
    ambientLight(110, 115, 130)
    directionalLight(255, 240, 210, -0.6, 0.9, -0.4)
    translate(width / 2, height / 2 + 60, 0)
    rotateX(radians(62))
    translate(-columns * cell / 2, -rows * cell + 180, 0)
    flight = frameCount * 0.15
    for row in range(rows):
        drawStrip(row, flight)


def drawStrip(row, flight):
    beginShape(TRIANGLE_STRIP)
    for column in range(columns + 1):
        for edge in (row, row + 1):
            h = heightAt(column, edge - flight)
            fill(colourOf(h))
            vertex(column * cell, edge * cell, h)
    endShape()


def heightAt(column, row):
    return max(noise(column * 0.11 + 100, row * 0.11 + 1000) * 260 - 90, 0)


def colourOf(h):
    water = color(64, 120, 180)
    grass = color(96, 150, 72)
    rock = color(128, 112, 96)
    snow = color(250, 250, 255)
    if h == 0:
        return water
    if h < 60:
        return lerpColor(grass, rock, h / 60)
    return lerpColor(rock, snow, constrain((h - 60) / 40, 0, 1))

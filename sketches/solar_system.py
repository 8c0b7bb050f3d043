"""Solar system: pushMatrix() remembers the sun for each planet, and the planet for its moons."""
# check: compare frames=1,30

# distance, radius, days for one turn around the sun, where it begins, colour, moons
planets = [
    (78, 7, 88, 0.4, "#B9A78F", 0),
    (116, 12, 225, 3.5, "#E0B868", 0),
    (164, 14, 365, 2.2, "#4C8FD8", 1),
    (215, 10, 687, 5.9, "#C8553D", 2),
    (285, 28, 4333, 0.7, "#D8A878", 4),
]
stars = []


def setup():
    size(640, 400, P3D)
    sphereDetail(20)
    for i in range(250):
        stars.append((random(-300, 940), random(-200, 600), random(1, 3)))


def draw():
    background(10, 10, 26)
    drawStars()
    translate(width / 2, height / 2, -60)
    rotateX(radians(-28))
    drawOrbits()
    noStroke()
    fill(255, 214, 90)
    sphere(42)

    # The sun shines from where it is, on all that is drawn after this.
    ambientLight(60, 60, 75)
    pointLight(255, 246, 225, 0, 0, 0)
    for distance, radius, year, start, colour, moons in planets:
        pushMatrix()
        rotateY(start + TWO_PI * frameCount / year)
        translate(distance, 0, 0)
        fill(colour)
        sphere(radius)
        drawMoons(moons, radius)
        popMatrix()


def drawMoons(count, radius):
    fill(210)
    for i in range(count):
        pushMatrix()
        rotateY(frameCount * 0.08 + i * TWO_PI / count)
        translate(radius + 9, 0, 0)
        sphere(3)
        popMatrix()


def drawOrbits():
    noFill()
    stroke(70, 80, 120)
    strokeWeight(1)
    pushMatrix()
    rotateX(HALF_PI)
    for planet in planets:
        circle(0, 0, planet[0] * 2)
    popMatrix()


def drawStars():
    stroke(220, 225, 255)
    for x, y, thickness in stars:
        strokeWeight(thickness)
        point(x, y, -300)

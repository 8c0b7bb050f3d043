"""Particles: a fountain of PVectors, which gravity pulls down."""
# check: compare frames=1,30

gravity = PVector(0, 0.09)
particles = []


class Particle:
    def __init__(self, place):
        self.place = place
        self.velocity = PVector(random(-2.2, 2.2), random(-7.5, -5))
        self.life = 1.0
        self.colour = lerpColor(color(255, 90, 40), color(255, 210, 80), random(1))

    def update(self):
        self.velocity.add(gravity)
        self.place.add(self.velocity)
        self.life -= 0.011
        if self.place.y > height - 40 and self.velocity.y > 0:
            self.velocity.y *= -0.45

    def show(self):
        fill(red(self.colour), green(self.colour), blue(self.colour), 110 * self.life)
        circle(self.place.x, self.place.y, 6 + 18 * self.life)


def setup():
    size(640, 420, P2D)
    noStroke()
    for i in range(60):  # as if it had been running for a while
        step()


def draw():
    background(14, 12, 28)
    fill(36, 32, 58)
    rect(0, height - 40, width, 40)
    step()
    blendMode(ADD)
    for particle in particles:
        particle.show()
    blendMode(BLEND)


def step():
    for i in range(4):
        particles.append(Particle(PVector(width / 2 + random(-6, 6), height - 45)))
    for particle in particles:
        particle.update()
    particles[:] = [particle for particle in particles if particle.life > 0]

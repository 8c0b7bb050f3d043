"""Flow field: walkers follow the directions that noise() gives, and leave their traces."""
# check: compare frames=1,30

walkers = []


def setup():
    size(640, 420, P2D)
    background(16, 20, 34)
    for i in range(400):
        walkers.append([random(width), random(height)])


def draw():
    strokeWeight(2)
    for i, walker in enumerate(walkers):
        x, y = walker
        angle = noise(x * 0.006, y * 0.006, frameCount * 0.002) * TWO_PI * 2
        newX = x + cos(angle) * 3
        newY = y + sin(angle) * 3
        stroke(lerpColor(color(255, 120, 60, 70), color(70, 190, 255, 70), i / len(walkers)))
        line(x, y, newX, newY)
        if 0 <= newX < width and 0 <= newY < height:
            walker[0] = newX
            walker[1] = newY
        else:
            walker[0] = random(width)
            walker[1] = random(height)

"""W7: 1,000 tinted images, of four pictures."""


def setup():
    global sprites
    size(640, 480, P2D)
    sprites = []
    for k in range(4):
        sprite = createImage(32, 32, ARGB)
        sprite.loadPixels()
        for i in range(1024):
            sprite.pixels[i] = color((i * 3 + k * 40) & 255, i & 255, 200, 255)
        sprite.updatePixels()
        sprites.append(sprite)


def draw():
    background(0)
    for i in range(1000):
        tint(i & 255, 255, 128, 200)
        image(sprites[i // 250 & 3], (i * 37) % width, (i * 53) % height, 32, 32)

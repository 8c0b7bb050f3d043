"""Game of Life: two canvases by turns; each generation is drawn from the one before it."""
# check: compare frames=1,30

cell = 4
now = None
following = None
rule = None
ink = None


def setup():
    global now, following, rule, ink
    size(560, 420, P2D)
    noSmooth()
    now = createGraphics(width // cell, height // cell, P2D)
    following = createGraphics(width // cell, height // cell, P2D)
    rule = loadShader("life.frag")
    ink = loadShader("life_ink.frag")
    fillByChance()


def draw():
    global now, following
    following.beginDraw()
    following.shader(rule)
    following.image(now, 0, 0)
    following.endDraw()
    now, following = following, now  # ping-pong: what was just written is read the next time

    ink.set("cells", float(now.width), float(now.height))
    shader(ink)
    image(now, 0, 0, width, height)
    resetShader()


def fillByChance():
    now.beginDraw()
    now.background(0)
    for x in range(now.width):
        for y in range(now.height):
            if random(1) < 0.28:
                now.set(x, y, color(255, 0, 0))
    now.endDraw()


def mousePressed():
    """Start anew."""
    fillByChance()

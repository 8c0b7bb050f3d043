"""Drawing: the mouse paints, keys 1 to 5 choose a colour, + and - the brush, c clears."""
# check: compare frames=1,30

colours = ["#2D3047", "#E0475B", "#F2A541", "#3FA796", "#4A7FD6"]
chosen = 0
thickness = 8


def setup():
    size(640, 420, P2D)
    background(252, 250, 244)
    textSize(14)
    fill(190)
    text("Press the mouse and draw.", 24, 40)


def draw():
    if mousePressed and mouseY < height - 50:
        stroke(colours[chosen])
        strokeWeight(thickness)
        line(pmouseX, pmouseY, mouseX, mouseY)
    drawPalette()


def drawPalette():
    noStroke()
    fill(230, 226, 214)
    rect(0, height - 50, width, 50)
    for i, colour in enumerate(colours):
        x = 34 + i * 44
        if i == chosen:
            stroke(60)
            strokeWeight(3)
        else:
            noStroke()
        fill(colour)
        circle(x, height - 25, 30)
    noStroke()
    fill(colours[chosen])
    circle(272, height - 25, thickness)
    fill(80)
    text("1-5 colour    + - brush    c clear    s save", 312, height - 20)


def mousePressed():
    """Choose a colour by a click on it."""
    global chosen
    if mouseY > height - 50:
        chosen = constrain((mouseX - 12) // 44, 0, len(colours) - 1)


def keyPressed():
    global chosen, thickness
    if key in "12345":
        chosen = int(key) - 1
    elif key == "+":
        thickness = min(thickness + 2, 40)
    elif key == "-":
        thickness = max(thickness - 2, 2)
    elif key == "c":
        background(252, 250, 244)
    elif key == "s":
        save("drawing.png")

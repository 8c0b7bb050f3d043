"""Cube map: six pictures of a room make a box around everything; a ball of chrome mirrors them."""
# check: compare frames=1,30

# Cube maps are sketchkit's own: Processing takes no pictures for a samplerCube.
# For each side: its colour, its middle, and where the right and lower edges of its picture are.
sides = [
    ("#D96C4A", (1, 0, 0), (0, 0, -1), (0, -1, 0)),
    ("#3F88A5", (-1, 0, 0), (0, 0, 1), (0, -1, 0)),
    ("#76502F", (0, 1, 0), (1, 0, 0), (0, 0, 1)),  # y points down: this is the floor
    ("#F4EBDD", (0, -1, 0), (1, 0, 0), (0, 0, -1)),
    ("#E3B23C", (0, 0, 1), (1, 0, 0), (0, -1, 0)),
    ("#5C946E", (0, 0, -1), (-1, 0, 0), (0, -1, 0)),
]
room, mirror = None, None


def setup():
    global room, mirror
    size(560, 420, P3D)
    noStroke()
    pictures = [createSide(128, *side) for side in sides]
    room = loadShader("room.frag", "mirror.vert")
    room.set("surroundings", pictures)
    mirror = loadShader("cube_map.frag", "mirror.vert")
    mirror.set("surroundings", pictures)


def draw():
    perspective(HALF_PI, width / height, 10, 3000)  # wide, to see much of the room
    translate(width / 2, height / 2)
    room.set("turn", frameCount * 0.02)
    shader(room)
    box(1500)
    mirror.set("turn", frameCount * 0.02)
    shader(mirror)
    sphere(180)
    resetShader()


def createSide(pixels, tone, middle, right, down):
    """Return one side of the room: each pixel is painted by where it lies, from -1 to 1."""
    picture = createImage(pixels, pixels, RGB)
    for row in range(pixels):
        for column in range(pixels):
            u, v = (2 * column + 1) / pixels - 1, (2 * row + 1) / pixels - 1
            place = [middle[axis] + u * right[axis] + v * down[axis] for axis in range(3)]
            picture.set(column, row, paint(*place, color(tone)))
    return picture


def paint(x, y, z, wall):
    if y > 0.99:  # planks
        return color(150, 104, 66) if int(x * 6 + 6) % 2 else wall
    if y < -0.99:  # the ceiling, with a round lamp
        return color(255, 240, 170) if dist(x, z, 0, 0) < 0.4 else wall
    across = min(abs(x), abs(z))  # on the wall, from its middle
    if abs(y + 0.15) < 0.4 and 0.03 < across < 0.35:  # the panes of a window
        return lerpColor(color(206, 236, 250), color(90, 160, 220), 0.5 - y)
    isFrame = abs(y + 0.15) < 0.45 and across < 0.4
    return color(250) if isFrame else lerpColor(wall, color(40, 30, 40), 0.2 + 0.2 * y)

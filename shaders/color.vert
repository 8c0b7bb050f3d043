#version 330 core
// Untextured, unlit fills; strokes of P2D. Positions are in eye space.
uniform mat4 projection;
uniform float y_sign; // -1 turns the picture over: see draw/resources.py, Target

in vec3 position;
in vec4 color;

out vec4 vert_color;

void main() {
    gl_Position = projection * vec4(position, 1.0);
    gl_Position.y *= y_sign;
    vert_color = color;
}

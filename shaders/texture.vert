#version 330 core
// Textured, unlit fills; `color` is the tint.
uniform mat4 projection;
uniform float y_sign;

in vec3 position;
in vec4 color;
in vec2 uv;

out vec4 vert_color;
out vec2 vert_uv;

void main() {
    gl_Position = projection * vec4(position, 1.0);
    gl_Position.y *= y_sign;
    vert_color = color;
    vert_uv = uv;
}

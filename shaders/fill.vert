#version 330 core
// Unlit fills, strokes of P2D among them. Of a textured fill, `color` is the tint. Without a
// texture, `uv` is read by nobody and is not bound.
uniform mat4 transform; // from eye space to clip space; of a mesh, from its own
uniform vec2 v_range;   // where v begins, and how far it goes
uniform float y_sign; // -1 turns the picture over: see draw/resources.py, Target

in vec3 position;
in vec4 color;
in vec2 uv;

out vec4 vert_color;
out vec2 vert_uv;

void main() {
    gl_Position = transform * vec4(position, 1.0);
    gl_Position.y *= y_sign;
    vert_color = color;
    vert_uv = vec2(uv.x, v_range.x + v_range.y * uv.y);
}

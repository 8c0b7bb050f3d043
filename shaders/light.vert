#version 330 core
// Lit fills; of a textured one, `color` is the tint. Without a texture, `uv` is not bound.
uniform mat4 projection;
uniform float y_sign;

in vec3 position;
in vec4 color;
in vec3 normal;
in vec4 ambient;
in vec4 specular;
in vec4 emissive;
in float shininess;
in vec2 uv;

out vec4 front_color;
out vec4 back_color;
out vec2 vert_uv;

#include "lighting.glsl"

void main() {
    gl_Position = projection * vec4(position, 1.0);
    gl_Position.y *= y_sign;
    Lit lit = light(position, normalize(normal), color, ambient, specular, emissive, shininess);
    front_color = lit.front;
    back_color = lit.back;
    vert_uv = uv;
}

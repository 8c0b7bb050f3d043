#version 330 core
// Lit fills; of a textured one, `color` is the tint. Without a texture, `uv` is not bound.
uniform mat4 transform;
uniform mat4 modelview; // to eye space: of a mesh alone it is not the identity
uniform mat3 normal_matrix;
uniform vec2 v_range;
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
    gl_Position = transform * vec4(position, 1.0);
    gl_Position.y *= y_sign;
    vec3 place = (modelview * vec4(position, 1.0)).xyz;
    vec3 unit = normalize(normal_matrix * normal);
    Lit lit = light(place, unit, color, ambient, specular, emissive, shininess);
    front_color = lit.front;
    back_color = lit.back;
    vert_uv = vec2(uv.x, v_range.x + v_range.y * uv.y);
}

#version 330 core
// Stands before a fragment shader of the sketch's for lit fills.
uniform mat4 transform;
uniform mat4 modelview;
uniform mat3 normalMatrix;
uniform mat4 texMatrix;
uniform float y_sign;

in vec4 position;
in vec4 color;
in vec3 normal;
in vec4 ambient;
in vec4 specular;
in vec4 emissive;
in float shininess;
in vec2 texCoord;

out vec4 vertColor;
out vec4 backVertColor;
out vec4 vertTexCoord;

#include "lighting.glsl"

void main() {
    gl_Position = transform * position;
    gl_Position.y *= y_sign;
    vec3 place = (modelview * position).xyz;
    Lit lit = light(place, normalize(normalMatrix * normal), color, ambient, specular, emissive,
                    shininess);
    vertColor = lit.front;
    backVertColor = lit.back;
    vertTexCoord = texMatrix * vec4(texCoord, 1.0, 1.0);
}

#version 330 core
// Stands before a fragment shader of the sketch's: hands it what Processing's own vertex shaders do.
uniform mat4 transform;
uniform mat4 texMatrix;
uniform float y_sign;

in vec4 position;
in vec4 color;
in vec2 texCoord;

out vec4 vertColor;
out vec4 vertTexCoord;

void main() {
    gl_Position = transform * position;
    gl_Position.y *= y_sign;
    vertColor = color;
    vertTexCoord = texMatrix * vec4(texCoord, 1.0, 1.0);
}

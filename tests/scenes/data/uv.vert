uniform mat4 transform;
attribute vec4 position;
attribute vec2 texCoord;
varying vec4 vertColor;

void main() {
    gl_Position = transform * position;
    vertColor = vec4(texCoord, 0.5, 1.0);
}

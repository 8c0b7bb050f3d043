uniform mat4 transform;
attribute vec4 position;
attribute float heat;
varying vec4 vertColor;

void main() {
    gl_Position = transform * position;
    vertColor = vec4(heat, 0.3, 1.0 - heat, 1.0);
}

uniform mat4 transform;
uniform mat4 modelview;
attribute vec4 position;
attribute vec4 tip;
varying vec4 vertColor;

void main() {
    gl_Position = transform * position;
    vertColor = vec4(fract((modelview * tip).xy / 50.0), 0.5, 1.0);
}

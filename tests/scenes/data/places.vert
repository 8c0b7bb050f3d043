uniform mat4 transform;
attribute vec4 vertex;
attribute vec3 normal;
varying vec4 vertColor;

void main() {
    gl_Position = transform * vertex;
    vertColor = vec4(fract(vertex.xyz / 50.0) * 0.5 + normal * 0.5, 1.0);
}

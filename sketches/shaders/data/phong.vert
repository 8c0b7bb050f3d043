// Phong shading, first half: places and normals go on to the fragments.
#define PROCESSING_LIGHT_SHADER

uniform mat4 transform;
uniform mat4 modelview;
uniform mat3 normalMatrix;

attribute vec4 vertex;
attribute vec4 color;
attribute vec3 normal;

varying vec4 col;
varying vec3 place;  // as seen from the eye, which is at 0, 0, 0
varying vec3 direction;

void main() {
  gl_Position = transform * vertex;
  col = color;
  place = vec3(modelview * vertex);
  direction = normalMatrix * normal;
}

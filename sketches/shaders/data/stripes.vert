// Hands on the place of a vertex on its own solid, and how much the surface there faces the eye.
#define PROCESSING_COLOR_SHADER

uniform mat4 transform;
uniform mat3 normalMatrix;

attribute vec4 vertex;
attribute vec3 normal;

varying vec3 place;
varying float facing;

void main() {
  gl_Position = transform * vertex;
  place = vertex.xyz;
  facing = normalize(normalMatrix * normal).z;
}

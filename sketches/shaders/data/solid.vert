// For patterns that go through a solid: its own coordinates are handed on, and what light needs.
#define PROCESSING_LIGHT_SHADER

uniform mat4 transform;
uniform mat4 modelview;
uniform mat3 normalMatrix;
uniform vec4 lightPosition;

attribute vec4 vertex;
attribute vec3 normal;

varying vec3 place;   // in the solid: the pattern is computed from it
varying vec3 side;    // where the surface looks to, in the solid's coordinates
varying vec3 facing;  // the same, as seen from the eye
varying vec3 toLight;

void main() {
  gl_Position = transform * vertex;
  place = vertex.xyz;
  side = normal;
  facing = normalMatrix * normal;
  toLight = lightPosition.xyz - vec3(modelview * vertex);
}

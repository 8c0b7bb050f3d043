// For mirrors: where the eye sees the surface, and where that looks to.
#define PROCESSING_COLOR_SHADER

uniform mat4 transform;
uniform mat4 modelview;
uniform mat3 normalMatrix;

attribute vec4 vertex;
attribute vec3 normal;

varying vec3 place;
varying vec3 facing;

void main() {
  gl_Position = transform * vertex;
  place = vec3(modelview * vertex);
  facing = normalMatrix * normal;
}

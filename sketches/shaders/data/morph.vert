// Morph targets: the differences of two expressions from the calm face, each by its weight.
#define PROCESSING_COLOR_SHADER

uniform mat4 transform;
uniform float joy;
uniform float surprise;

attribute vec4 vertex;
attribute vec4 color;
attribute vec3 joyPlace;       // from attribPosition("joyPlace", ...)
attribute vec3 surprisePlace;

varying vec4 col;

void main() {
  vec3 place = vertex.xyz;
  place += joy * (joyPlace - vertex.xyz);
  place += surprise * (surprisePlace - vertex.xyz);
  gl_Position = transform * vec4(place, 1.0);
  col = color;
}

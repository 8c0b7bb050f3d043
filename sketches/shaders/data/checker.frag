// A checkerboard in three dimensions.
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif

uniform vec3 light;
uniform vec3 dark;
uniform float cube;  // its side

varying vec3 place;
varying vec3 facing;
varying vec3 toLight;

void main() {
  // The 0.01 keeps the faces of a box off the boundary between two cubes.
  vec3 number = floor((place + 0.01) / cube);
  float isDark = mod(number.x + number.y + number.z, 2.0);

  float shade = 0.25 + 0.75 * max(0.0, dot(normalize(facing), normalize(toLight)));
  gl_FragColor = vec4(mix(light, dark, isDark) * shade, 1.0);
}

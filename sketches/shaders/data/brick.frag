// Bricks and the mortar between them; every second row is moved by half a brick.
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif

uniform vec2 brick;   // length and height, with the joint
uniform float joint;  // the mortar between two bricks

varying vec3 place;
varying vec3 side;
varying vec3 facing;
varying vec3 toLight;

// A number from 0 to 1 that looks like chance, and is always the same for the same brick.
float chance(vec2 number) {
  return fract(sin(dot(number, vec2(12.9898, 78.233))) * 43758.5453);
}

void main() {
  // A wall has two directions: which two, its normal says.
  vec2 wall = abs(side.x) > 0.5 ? place.zy : abs(side.y) > 0.5 ? place.xz : place.xy;
  float row = floor(wall.y / brick.y);
  wall.x += 0.5 * brick.x * mod(row, 2.0);
  vec2 number = floor(wall / brick);
  vec2 within = wall - number * brick;

  vec3 tone = mix(vec3(0.60, 0.24, 0.17), vec3(0.80, 0.42, 0.28), chance(number));
  if (within.x < joint || within.y < joint) tone = vec3(0.82, 0.79, 0.72);

  float shade = 0.3 + 0.7 * max(0.0, dot(normalize(facing), normalize(toLight)));
  gl_FragColor = vec4(tone * shade, 1.0);
}

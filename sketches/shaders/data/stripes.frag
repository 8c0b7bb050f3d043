// Slanting stripes in three colours.
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif

uniform float shift;

varying vec3 place;
varying float facing;

void main() {
  float along = fract((place.x + 2.0 * place.y) / 90.0 + shift);  // 0 to 1, then anew
  vec3 tone = vec3(0.93, 0.30, 0.25);
  if (along > 0.5) tone = vec3(0.99, 0.86, 0.62);
  if (along > 0.9) tone = vec3(0.12, 0.22, 0.38);
  gl_FragColor = vec4(tone * (0.55 + 0.45 * abs(facing)), 1.0);
}

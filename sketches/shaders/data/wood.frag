// Rings of a tree, a little out of round.
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif

varying vec3 place;
varying vec3 facing;
varying vec3 toLight;

void main() {
  // How far from the axis of the trunk: sines of several lengths keep it from being too regular.
  vec2 across = place.yz + vec2(70.0, 18.0);
  across += 5.0 * sin(place.x * 0.017 + vec2(0.0, 2.0)) + 1.5 * sin(across.yx * 0.11);
  float radius = length(across);

  // A ring begins with light wood of the spring, darkens slowly, and ends at once.
  float ring = fract(radius / 9.0 + 0.15 * sin(place.x * 0.05));
  float dark = smoothstep(0.2, 0.9, ring) - smoothstep(0.92, 1.0, ring);
  vec3 tone = mix(vec3(0.86, 0.64, 0.38), vec3(0.52, 0.30, 0.14), dark);
  float grain = fract(sin(dot(floor(across * 2.0), vec2(12.9898, 78.233))) * 43758.5453);
  tone *= 0.95 + 0.05 * grain;

  float shade = 0.3 + 0.75 * max(0.0, dot(normalize(facing), normalize(toLight)));
  gl_FragColor = vec4(tone * shade, 1.0);
}

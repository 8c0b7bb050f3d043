// Marble: Perlin noise in GLSL, sums of it, and veins where a sine of them turns.
#ifdef GL_ES
precision highp float;
precision mediump int;
#endif

varying vec3 place;
varying vec3 facing;
varying vec3 toLight;

// A direction for each corner of the grid: it looks like chance, and is always the same.
vec3 gradient(vec3 corner) {
  vec3 mixed = vec3(dot(corner, vec3(127.1, 311.7, 74.7)), dot(corner, vec3(269.5, 183.3, 246.1)),
                    dot(corner, vec3(113.5, 271.9, 124.6)));
  return 2.0 * fract(sin(mixed) * 43758.5453) - 1.0;
}

// What the corner of a cell says about a place in the cell.
float slope(vec3 cell, vec3 within, vec3 corner) {
  return dot(gradient(cell + corner), within - corner);
}

// Perlin noise, about -1 to 1: the slopes of the eight corners of a cell, blended.
float noise(vec3 p) {
  vec3 cell = floor(p);
  vec3 w = p - cell;
  vec3 s = w * w * w * (w * (6.0 * w - 15.0) + 10.0);  // flat at 0 and at 1: no edges show
  vec4 left = vec4(slope(cell, w, vec3(0, 0, 0)), slope(cell, w, vec3(0, 1, 0)),
                   slope(cell, w, vec3(0, 0, 1)), slope(cell, w, vec3(0, 1, 1)));
  vec4 right = vec4(slope(cell, w, vec3(1, 0, 0)), slope(cell, w, vec3(1, 1, 0)),
                    slope(cell, w, vec3(1, 0, 1)), slope(cell, w, vec3(1, 1, 1)));
  vec4 x = mix(left, right, s.x);
  vec2 xy = mix(x.xz, x.yw, s.y);
  return mix(xy.x, xy.y, s.z);
}

// Finer and finer noise, which counts less and less.
float turbulence(vec3 p) {
  float sum = 0.0;
  float size = 1.0;
  for (int octave = 0; octave < 5; octave++) {
    sum += size * abs(noise(p / size));
    size *= 0.5;
  }
  return sum;
}

void main() {
  vec3 p = place / 70.0;
  float vein = abs(sin(3.0 * (p.x + 0.6 * p.y) + 5.0 * turbulence(p)));
  vec3 tone = mix(vec3(0.24, 0.30, 0.34), vec3(0.93, 0.92, 0.88), pow(vein, 0.45));

  vec3 n = normalize(facing);
  vec3 dir = normalize(toLight);
  float shade = 0.3 + 0.7 * max(0.0, dot(n, dir));
  float gloss = pow(max(0.0, reflect(-dir, n).z), 40.0);
  gl_FragColor = vec4(tone * shade + 0.5 * gloss, 1.0);
}

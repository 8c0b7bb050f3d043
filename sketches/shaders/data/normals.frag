// Normal mapping, second half: the picture's normal takes the place of the surface's.
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif

uniform sampler2D texture;
uniform sampler2D normals;

varying vec3 outwards;
varying vec3 right;
varying vec3 down;
varying vec3 toLight;
varying vec2 uv;

void main() {
  vec3 leaning = 2.0 * texture2D(normals, uv).rgb - 1.0;
  vec3 n = normalize(leaning.x * right + leaning.y * down + leaning.z * outwards);

  vec3 dir = normalize(toLight);
  float light = max(0.0, dot(dir, n));
  light *= 1.6 / (1.0 + dot(toLight, toLight) / 30000.0);  // weaker farther away
  vec3 tone = vec3(0.72, 0.70, 0.66) * texture2D(texture, uv).rgb;
  gl_FragColor = vec4(tone * (0.12 + 1.4 * light) * vec3(1.0, 0.93, 0.80), 1.0);
}

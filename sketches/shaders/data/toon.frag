// Light in steps: a few shades take the place of the smooth ones.
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif

uniform vec3 lightNormal[8];  // where a directional light shines to

varying vec4 col;
varying vec3 place;
varying vec3 direction;

void main() {
  vec3 n = normalize(direction);
  float light = dot(-lightNormal[0], n);

  float shade = 0.35;
  if (light > 0.1) shade = 0.6;
  if (light > 0.5) shade = 0.85;
  if (light > 0.95) shade = 1.25;

  // Where the surface turns away from the eye, it is drawn with ink.
  float facing = dot(n, normalize(-place));
  gl_FragColor = vec4(facing < 0.28 ? vec3(0.15, 0.08, 0.12) : col.rgb * shade, col.a);
}

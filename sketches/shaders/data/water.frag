// Looks up a picture a little beside the right place: rings run outwards from the middle.
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif

uniform sampler2D texture;
uniform float time;

varying vec4 col;
varying vec4 outputTexCoord;

void main() {
  vec2 place = outputTexCoord.xy;
  vec2 outwards = place - vec2(0.5);
  float ring = sin(50.0 * length(outwards) - 3.0 * time);

  vec4 seen = texture2D(texture, place + 0.012 * ring * normalize(outwards + vec2(0.0001)));
  float glint = smoothstep(0.85, 1.0, ring) * 0.25;
  gl_FragColor = vec4(seen.rgb + glint, seen.a) * col;
}

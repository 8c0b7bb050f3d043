// A sphere map: the mirrored direction is looked up in a picture of a ball of chrome.
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif

uniform sampler2D surroundings;

varying vec3 place;
varying vec3 facing;

void main() {
  vec3 seen = reflect(normalize(place), normalize(facing));

  // Halfway between where we look from and what we see is the normal of the ball there.
  vec3 ball = normalize(seen + vec3(0.0, 0.0, 1.0));
  gl_FragColor = vec4(texture2D(surroundings, 0.5 + 0.5 * ball.xy).rgb, 1.0);
}

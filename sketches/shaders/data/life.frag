// Conway's rule. Red: whether a cell lives. Green: a trace of it, which fades after its death.
#define PROCESSING_TEXTURE_SHADER
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif

uniform sampler2D texture;
uniform vec2 texOffset;

varying vec4 vertTexCoord;

float alive(float right, float down) {
  // fract(): what leaves the picture on one side comes in on the other.
  return step(0.5, texture2D(texture, fract(vertTexCoord.st + vec2(right, down) * texOffset)).r);
}

void main() {
  float neighbours = alive(-1.0, -1.0) + alive(0.0, -1.0) + alive(1.0, -1.0)
                   + alive(-1.0, 0.0) + alive(1.0, 0.0)
                   + alive(-1.0, 1.0) + alive(0.0, 1.0) + alive(1.0, 1.0);
  float lives = 0.0;
  if (neighbours == 3.0) lives = 1.0;  // it is born, or lives on
  if (neighbours == 2.0) lives = alive(0.0, 0.0);

  float trace = texture2D(texture, vertTexCoord.st).g;
  gl_FragColor = vec4(lives, max(lives, trace - 0.04), 0.0, 1.0);
}

// Shows the cells large, in colours, and sharp: each pixel looks into the middle of its cell.
#define PROCESSING_TEXTURE_SHADER
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif

uniform sampler2D texture;
uniform vec2 cells;  // how many there are across and down

varying vec4 vertTexCoord;

void main() {
  vec4 cell = texture2D(texture, (floor(vertTexCoord.st * cells) + 0.5) / cells);
  vec3 tone = mix(vec3(0.06, 0.07, 0.14), vec3(0.16, 0.44, 0.62), cell.g);
  gl_FragColor = vec4(mix(tone, vec3(1.0, 0.86, 0.45), cell.r), 1.0);
}

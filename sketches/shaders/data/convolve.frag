// Convolution: a pixel and its eight neighbours, each multiplied by a number, are added up.
#define PROCESSING_TEXTURE_SHADER
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif

uniform sampler2D texture;  // what was drawn so far
uniform vec2 texOffset;     // from one of its pixels to the next
uniform float kernel[9];    // row by row

varying vec4 vertTexCoord;

void main() {
  vec3 sum = vec3(0.0);
  for (int row = 0; row < 3; row++) {
    for (int column = 0; column < 3; column++) {
      vec2 beside = vec2(float(column - 1), float(row - 1)) * texOffset;
      sum += kernel[3 * row + column] * texture2D(texture, vertTexCoord.st + beside).rgb;
    }
  }
  gl_FragColor = vec4(sum, 1.0);
}

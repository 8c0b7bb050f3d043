// A texture's first half: each vertex knows its place in the picture, from 0 to 1.
#define PROCESSING_TEXTURE_SHADER

uniform mat4 transform;
uniform mat4 texMatrix;

attribute vec4 vertex;
attribute vec4 color;
attribute vec2 texCoord;

varying vec4 col;
varying vec4 outputTexCoord;

void main() {
  gl_Position = transform * vertex;
  col = color;
  outputTexCoord = texMatrix * vec4(texCoord, 1.0, 1.0);
}

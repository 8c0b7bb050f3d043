// Where each vertex goes, and the colour that fill() gave it.
#define PROCESSING_COLOR_SHADER

uniform mat4 transform;

attribute vec4 vertex;
attribute vec4 color;

varying vec4 col;

void main() {
  gl_Position = transform * vertex;
  col = color;
}

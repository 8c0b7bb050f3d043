// Paints the colour that the vertex shader has worked out, blended between the vertices.
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif

varying vec4 col;

void main() {
  gl_FragColor = col;
}

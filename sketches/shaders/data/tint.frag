// Multiplies each colour by a tint: white stays the tint, black stays black.
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif

uniform vec3 tint;

varying vec4 col;

void main() {
  gl_FragColor = vec4(col.rgb * tint, col.a);
}

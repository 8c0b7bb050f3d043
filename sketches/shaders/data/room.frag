// The room itself: what lies in the direction of each pixel.
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif

uniform samplerCube surroundings;
uniform float turn;

varying vec3 place;
varying vec3 facing;

void main() {
  mat3 around = mat3(cos(turn), 0.0, sin(turn), 0.0, 1.0, 0.0, -sin(turn), 0.0, cos(turn));
  gl_FragColor = textureCube(surroundings, around * place);
}

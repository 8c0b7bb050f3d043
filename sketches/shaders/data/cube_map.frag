// A cube map: the mirrored direction meets a box of six pictures, which is as large as the world.
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif

uniform samplerCube surroundings;
uniform float turn;  // of the room around the ball

varying vec3 place;
varying vec3 facing;

void main() {
  vec3 seen = reflect(normalize(place), normalize(facing));
  mat3 around = mat3(cos(turn), 0.0, sin(turn), 0.0, 1.0, 0.0, -sin(turn), 0.0, cos(turn));
  gl_FragColor = vec4(textureCube(surroundings, around * seen).rgb * 0.95, 1.0);
}

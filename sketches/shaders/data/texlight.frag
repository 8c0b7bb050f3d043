// Multiplies the picture by the light.
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif

uniform sampler2D texture;

varying vec4 lightColour;
varying vec4 outputTexCoord;

void main() {
  gl_FragColor = lightColour * texture2D(texture, outputTexCoord.xy);
}

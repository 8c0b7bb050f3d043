#ifdef GL_ES
precision mediump float;
#endif
uniform sampler2D texture;
varying vec4 vertColor;
varying vec4 vertTexCoord;

void main() {
    gl_FragColor = texture2D(texture, vertTexCoord.st).gbra * vertColor;
}

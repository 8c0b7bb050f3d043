uniform sampler2D texture;
uniform vec2 texOffset;
varying vec4 vertTexCoord;

void main() {
    vec4 c = texture2D(texture, vertTexCoord.st + 5.0 * texOffset);
    gl_FragColor = vec4(1.0 - c.r, c.g, c.b * vertTexCoord.t, 1.0);
}

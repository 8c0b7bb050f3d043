varying vec4 vertColor;

void main() {
    gl_FragColor = vertColor;
}

varying vec4 vertColor;

void main() {
    gl_FragColor = vec4(vertColor.gbr, vertColor.a);
}

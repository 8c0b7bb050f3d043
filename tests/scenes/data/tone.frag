uniform vec3 tone;

void main() {
    gl_FragColor = vec4(tone, 0.5);
}

uniform vec2 resolution;
uniform vec4 viewport;

void main() {
    gl_FragColor = vec4(gl_FragCoord.xy / resolution, viewport.w / 100.0, 1.0);
}

uniform sampler2D ppixels;
uniform vec2 resolution;

void main() {
    gl_FragColor = vec4(texture2D(ppixels, gl_FragCoord.xy / resolution + 0.1).gbr + 0.1, 1.0);
}

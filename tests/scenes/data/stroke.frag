#define PROCESSING_LINE_SHADER
varying vec4 vertColor;

void main() {
    gl_FragColor = vec4(vertColor.rgb * 0.5 + vec3(0.0, 0.5, 0.2), 1.0);
}

#define PROCESSING_POINT_SHADER
varying vec4 vertColor;
varying vec2 place;

void main() {
    gl_FragColor = vec4(vertColor.rgb * length(place) / 10.0, 1.0);
}

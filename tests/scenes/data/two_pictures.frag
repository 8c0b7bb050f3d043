uniform sampler2D upper;
uniform sampler2D lower;
uniform vec2 size;

void main() {
    vec2 place = gl_FragCoord.xy / size;
    gl_FragColor = place.x < 0.5 ? texture2D(upper, place * 2.0) : texture2D(lower, fract(place * 2.0));
}

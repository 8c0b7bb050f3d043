struct Lamp {
    vec3 place;
    float power;
};

uniform float one;
uniform int whole;
uniform bool choice;
uniform vec2 two;
uniform vec3 three;
uniform vec4 four;
uniform float list[3];
uniform vec2 pairs[2];
uniform mat3 turn;
uniform mat4 move;
uniform Lamp lamp;

void main() {
    int column = int(gl_FragCoord.x / 10.0);
    vec3 c = vec3(0.0);
    if (column == 0) c.r = one;
    else if (column == 1) c.r = float(whole) / 10.0;
    else if (column == 2) c.r = choice ? 0.8 : 0.3;
    else if (column == 3) c.rg = two;
    else if (column == 4) c = three;
    else if (column == 5) c = four.rgb * four.a;
    else if (column == 6) c = vec3(list[0], list[1], list[2]);
    else if (column == 7) c = vec3(pairs[0], pairs[1].y);
    else if (column == 8) c = gl_FragCoord.y < 50.0 ? turn * vec3(0.1, 0.2, 0.3)
                                                    : (move * vec4(0.1, 0.2, 0.3, 1.0)).rgb;
    else c = lamp.place * lamp.power;
    gl_FragColor = vec4(c, 1.0);
}

#version 330 core
// Strokes of P3D, before a fragment shader of the sketch's.
uniform mat4 projection;
uniform mat4 modelview;
uniform float weight_scale;
uniform float y_sign;
uniform vec4 viewport;    // left, bottom, width and height, pixels
uniform vec3 scale;       // pulls the stroke toward the eye
uniform int perspective;  // whether the weight is a length in eye space

in vec3 position;
in vec4 color;
in vec4 direction; // to the other end; half the weight, its sign the side

out vec4 vertColor;

void main() {
    vec3 place = (modelview * vec4(position, 1.0)).xyz;
    vec3 other = (modelview * vec4(position + direction.xyz, 1.0)).xyz;
    vec4 here = projection * vec4(place * scale, 1.0);
    vec4 there = projection * vec4(other * scale, 1.0);

    // The direction on the screen is there.xy / there.w - here.xy / here.w; multiplied by both w
    // it is the same direction, and needs no division by what may be 0.
    vec2 along = (there.xy * here.w - here.xy * there.w) * viewport.zw;
    along = along == vec2(0.0) ? vec2(0.0) : normalize(along);
    vec2 across = vec2(-along.y, along.x) * direction.w * weight_scale;

    vec2 per_length = (projection * vec4(1.0, -1.0, 0.0, 0.0)).xy;
    vec2 per_pixel = here.w / (0.5 * viewport.zw);
    gl_Position = here;
    gl_Position.xy += across * (perspective == 1 ? per_length : per_pixel);
    gl_Position.y *= y_sign;
    vertColor = color;
}

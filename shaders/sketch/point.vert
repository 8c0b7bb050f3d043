#version 330 core
// Points of P3D, before a fragment shader of the sketch's.
uniform mat4 projection;
uniform mat4 transform;
uniform float weight_scale;
uniform float y_sign;
uniform vec4 viewport;    // left, bottom, width and height, pixels
uniform int perspective;  // whether the weight is a length in eye space

in vec3 position;
in vec4 color;
in vec2 offset; // from the place of the point to this corner

out vec4 vertColor;

void main() {
    gl_Position = transform * vec4(position, 1.0);
    vec2 per_length = (projection * vec4(1.0, -1.0, 0.0, 0.0)).xy;
    vec2 per_pixel = gl_Position.w / (0.5 * viewport.zw);
    gl_Position.xy += offset * weight_scale * (perspective == 1 ? per_length : per_pixel);
    gl_Position.y *= y_sign;
    vertColor = color;
}

#version 330 core
uniform sampler2D image;

in vec4 front_color;
in vec4 back_color;
in vec2 vert_uv;

out vec4 frag_color;

void main() {
    frag_color = texture(image, vert_uv) * (gl_FrontFacing ? front_color : back_color);
}

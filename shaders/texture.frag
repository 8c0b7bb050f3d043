#version 330 core
uniform sampler2D image;

in vec4 vert_color;
in vec2 vert_uv;

out vec4 frag_color;

void main() {
    frag_color = texture(image, vert_uv) * vert_color;
}

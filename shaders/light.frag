#version 330 core
in vec4 front_color;
in vec4 back_color;

out vec4 frag_color;

void main() {
    frag_color = gl_FrontFacing ? front_color : back_color;
}

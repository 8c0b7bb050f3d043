#version 330 core
// Takes the first sample of each pixel, as it is.
uniform sampler2DMS image;

out vec4 frag_color;

void main() {
    frag_color = texelFetch(image, ivec2(gl_FragCoord.xy), 0);
}

// Bends a flat cloth: a sine that runs along x moves the vertices up and down, and in depth.
#define PROCESSING_COLOR_SHADER

uniform mat4 transform;
uniform float time;
uniform float cloth;  // its width; x = 0 is where it is tied to the pole

attribute vec4 vertex;
attribute vec4 color;

varying vec4 col;

void main() {
  float free = vertex.x / cloth;  // 0 at the pole, 1 at the loose end
  float angle = 0.035 * vertex.x + 0.012 * vertex.y - time;

  vec4 bent = vertex;
  bent.z += 34.0 * free * sin(angle);
  bent.y += 10.0 * free * sin(angle + 1.0) + 26.0 * free * free;
  gl_Position = transform * bent;

  float shade = 0.86 + 0.22 * free * cos(angle);  // the slope of the sine: as if light fell on it
  col = vec4(color.rgb * shade, color.a);
}

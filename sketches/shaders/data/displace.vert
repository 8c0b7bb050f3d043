// Displacement: a vertex goes up by as much as a picture of heights is bright at its place.
#define PROCESSING_COLOR_SHADER

uniform mat4 transform;
uniform sampler2D heights;
uniform float side;  // of the square grid, whose middle is at 0, 0, 0
uniform float top;   // how high white is

attribute vec4 vertex;

varying vec4 col;

float heightAt(vec2 place) {
  return top * texture2D(heights, place / side + 0.5).r;
}

// Grass, rock and snow, from below to above; all that is below the sea is sea.
vec3 colourAt(float height) {
  vec3 tone = mix(vec3(0.87, 0.80, 0.58), vec3(0.36, 0.56, 0.26), smoothstep(24.0, 34.0, height));
  tone = mix(tone, vec3(0.50, 0.45, 0.42), smoothstep(55.0, 75.0, height));
  return mix(tone, vec3(1.0), smoothstep(92.0, 104.0, height));
}

void main() {
  float sea = 22.0;
  float height = heightAt(vertex.xz);
  vec4 lifted = vertex;
  lifted.y -= max(height, sea);  // up is -y
  gl_Position = transform * lifted;

  // The slope is what the height gains from one side of the vertex to the other.
  vec2 slope = vec2(heightAt(vertex.xz + vec2(4.0, 0.0)) - heightAt(vertex.xz - vec2(4.0, 0.0)),
                    heightAt(vertex.xz + vec2(0.0, 4.0)) - heightAt(vertex.xz - vec2(0.0, 4.0)));
  vec3 n = normalize(vec3(-slope.x, 8.0, -slope.y));
  float light = 0.35 + 0.75 * max(0.0, dot(n, normalize(vec3(-0.7, 0.8, 0.3))));
  vec3 tone = colourAt(height) * light;
  col = vec4(height > sea ? tone : vec3(0.16, 0.45, 0.60) + 0.010 * height, 1.0);
}

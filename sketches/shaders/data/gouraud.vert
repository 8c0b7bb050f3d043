// Gouraud shading: the light is worked out for each vertex; between them its colour is blended.
#define PROCESSING_LIGHT_SHADER

uniform mat4 transform;
uniform mat4 modelview;
uniform mat3 normalMatrix;
uniform int lightCount;
uniform vec4 lightPosition[8];
uniform vec3 lightDiffuse[8];

attribute vec4 vertex;
attribute vec4 color;
attribute vec3 normal;

varying vec4 col;

void main() {
  gl_Position = transform * vertex;
  vec3 place = vec3(modelview * vertex);  // as seen from the eye, which is at 0, 0, 0
  vec3 n = normalize(normalMatrix * normal);

  vec3 diffuse = vec3(0.0);
  vec3 highlight = vec3(0.0);
  for (int i = 0; i < lightCount; i++) {
    vec3 dir = normalize(lightPosition[i].xyz - place);
    diffuse += lightDiffuse[i] * max(0.0, dot(dir, n));
    vec3 mirrored = reflect(-dir, n);
    highlight += lightDiffuse[i] * pow(max(0.0, dot(mirrored, normalize(-place))), 30.0);
  }
  col = vec4(0.6 * diffuse * color.rgb + highlight, color.a);
}

// Texture and light: the light for each vertex, and its place in the picture.
#define PROCESSING_TEXLIGHT_SHADER

uniform mat4 transform;
uniform mat4 modelview;
uniform mat3 normalMatrix;
uniform mat4 texMatrix;
uniform vec4 lightPosition;  // of one light; for several: see gouraud.vert

attribute vec4 vertex;
attribute vec4 color;
attribute vec3 normal;
attribute vec2 texCoord;

varying vec4 lightColour;
varying vec4 outputTexCoord;

void main() {
  gl_Position = transform * vertex;
  vec3 vertexCamera = vec3(modelview * vertex);
  vec3 transformedNormal = normalize(normalMatrix * normal);

  vec3 dir = normalize(lightPosition.xyz - vertexCamera);
  float light = max(0.0, dot(dir, transformedNormal));
  lightColour = vec4(light, light, light, 1.0) * color;
  outputTexCoord = texMatrix * vec4(texCoord, 1.0, 1.0);
}

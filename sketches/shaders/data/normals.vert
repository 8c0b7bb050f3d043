// Normal mapping, first half: three directions of the surface, which the picture is measured in.
#define PROCESSING_TEXLIGHT_SHADER

uniform mat4 transform;
uniform mat4 modelview;
uniform mat3 normalMatrix;
uniform mat4 texMatrix;
uniform vec4 lightPosition;

attribute vec4 vertex;
attribute vec3 normal;
attribute vec2 texCoord;
attribute vec3 tangent;  // from attribNormal("tangent", ...)

varying vec3 outwards;
varying vec3 right;
varying vec3 down;
varying vec3 toLight;
varying vec2 uv;

void main() {
  gl_Position = transform * vertex;
  outwards = normalize(normalMatrix * normal);
  right = normalize(normalMatrix * tangent);
  down = cross(outwards, right);
  toLight = lightPosition.xyz - vec3(modelview * vertex);
  uv = (texMatrix * vec4(texCoord, 1.0, 1.0)).xy;
}

// For textured surfaces that are lit pixel by pixel: all that a fragment wants to know.
#define PROCESSING_TEXLIGHT_SHADER

uniform mat4 transform;
uniform mat4 modelview;
uniform mat3 normalMatrix;
uniform mat4 texMatrix;
uniform vec4 lightPosition;

attribute vec4 vertex;
attribute vec3 normal;
attribute vec2 texCoord;

varying vec3 place;   // as seen from the eye
varying vec3 facing;
varying vec3 toLight;
varying vec2 uv;

void main() {
  gl_Position = transform * vertex;
  place = vec3(modelview * vertex);
  facing = normalMatrix * normal;
  toLight = lightPosition.xyz - place;
  uv = (texMatrix * vec4(texCoord, 1.0, 1.0)).xy;
}

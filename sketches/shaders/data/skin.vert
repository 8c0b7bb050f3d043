// Skinning: each vertex is moved by up to four bones; weights say how much each of them counts.
#define PROCESSING_LIGHT_SHADER

uniform mat4 transform;
uniform mat4 modelview;
uniform mat3 normalMatrix;
uniform vec4 lightPosition;
uniform mat4 Transforms[4];  // of the bones: what each does to the bind pose

attribute vec4 vertex;
attribute vec4 color;
attribute vec3 normal;
attribute vec4 Weights;        // they sum to 1
attribute vec4 MatrixIndices;  // which bones they belong to

varying vec4 col;

void main() {
  mat4 bone = Weights.x * Transforms[int(MatrixIndices.x + 0.5)];
  bone += Weights.y * Transforms[int(MatrixIndices.y + 0.5)];
  bone += Weights.z * Transforms[int(MatrixIndices.z + 0.5)];
  bone += Weights.w * Transforms[int(MatrixIndices.w + 0.5)];
  vec4 moved = bone * vertex;
  gl_Position = transform * moved;

  vec3 n = normalize(normalMatrix * vec3(bone * vec4(normal, 0.0)));
  vec3 dir = normalize(lightPosition.xyz - vec3(modelview * moved));
  float light = 0.25 + 0.75 * max(0.0, dot(dir, n));
  col = vec4(color.rgb * light, color.a);
}

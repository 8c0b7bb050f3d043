#define PROCESSING_LINE_SHADER
uniform mat4 modelview; uniform mat4 projection; uniform vec4 viewport; uniform int perspective; uniform vec3 scale;
attribute vec4 position; attribute vec4 color; attribute vec4 direction;
varying vec4 vertColor;
void main() {
  vec4 posp = modelview * position;
  vec4 posq = modelview * (position + vec4(direction.xyz, 0.0));
  posp.xyz = posp.xyz * scale;
  posq.xyz = posq.xyz * scale;
  vec4 p = projection * posp; vec4 q = projection * posq;
  vec2 tangent = (q.xy * p.w - p.xy * q.w) * viewport.zw;
  tangent = length(tangent) == 0.0 ? vec2(0.0) : normalize(tangent);
  vec2 normal = vec2(-tangent.y, tangent.x);
  float thickness = direction.w * 1.5;
  vec2 offset = normal * thickness;
  vec2 perPixel = p.w / (0.5 * viewport.zw);
  vec2 perLength = (projection * vec4(1.0, -1.0, 0.0, 0.0)).xy;
  gl_Position.xy = p.xy + offset * mix(perPixel, perLength, float(perspective > 0));
  gl_Position.zw = p.zw;
  vertColor = color;
}
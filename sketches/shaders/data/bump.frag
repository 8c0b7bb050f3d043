// Bump mapping: the normal leans away from where the picture of heights rises.
#ifdef GL_ES
#extension GL_OES_standard_derivatives : enable
precision mediump float;
precision mediump int;
#endif

uniform sampler2D texture;  // of heights: black is low, white is high
uniform float depth;        // how many pixels deep the lowest ones are

varying vec3 place;
varying vec3 facing;
varying vec3 toLight;
varying vec2 uv;

float heightAt(vec2 at) {
  return depth * texture2D(texture, at).r;
}

void main() {
  vec3 n = normalize(facing);

  // dFdx() and dFdy() tell how something changes up to the next pixel: here where we are, ...
  vec3 right = dFdx(place);
  vec3 down = dFdy(place);
  // ... and how high the surface is there.
  float here = heightAt(uv);
  float rightRise = heightAt(uv + dFdx(uv)) - here;
  float downRise = heightAt(uv + dFdy(uv)) - here;

  // From both follows where on the surface it rises, and how steeply.
  vec3 acrossDown = cross(down, n);
  vec3 acrossRight = cross(n, right);
  float area = dot(right, acrossDown);
  vec3 rise = sign(area) * (rightRise * acrossDown + downRise * acrossRight);
  n = normalize(abs(area) * n - rise);

  vec3 dir = normalize(toLight);
  float light = max(0.0, dot(dir, n));
  float gloss = pow(max(0.0, dot(reflect(-dir, n), normalize(-place))), 24.0);
  gl_FragColor = vec4(vec3(1.0, 0.55, 0.10) * (0.2 + 0.8 * light) + 0.4 * gloss, 1.0);
}

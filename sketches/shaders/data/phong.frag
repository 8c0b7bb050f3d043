// Phong shading, second half: the light is worked out for each pixel. Compare gouraud.vert.
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif

uniform int lightCount;
uniform vec4 lightPosition[8];
uniform vec3 lightDiffuse[8];

varying vec4 col;
varying vec3 place;
varying vec3 direction;

void main() {
  vec3 n = normalize(direction);  // between two vertices it has become shorter

  vec3 diffuse = vec3(0.0);
  vec3 highlight = vec3(0.0);
  for (int i = 0; i < lightCount; i++) {
    vec3 dir = normalize(lightPosition[i].xyz - place);
    diffuse += lightDiffuse[i] * max(0.0, dot(dir, n));
    vec3 mirrored = reflect(-dir, n);
    highlight += lightDiffuse[i] * pow(max(0.0, dot(mirrored, normalize(-place))), 30.0);
  }
  gl_FragColor = vec4(0.6 * diffuse * col.rgb + highlight, col.a);
}

#define PROCESSING_TEXLIGHT_SHADER
uniform mat4 modelview;
uniform mat4 transform;
uniform mat3 normalMatrix;
uniform mat4 texMatrix;
uniform int lightCount;
uniform vec4 lightPosition[8];
uniform vec3 lightNormal[8];
uniform vec3 lightDiffuse[8];
attribute vec4 position;
attribute vec4 color;
attribute vec3 normal;
attribute vec2 texCoord;
varying vec4 vertColor;
varying vec4 vertTexCoord;

void main() {
    gl_Position = transform * position;
    vec3 place = vec3(modelview * position);
    vec3 n = normalize(normalMatrix * normal);
    vec3 sum = vec3(0.1);
    for (int i = 0; i < lightCount; i++) {
        bool isPlaced = lightPosition[i].w > 0.5;
        vec3 to = isPlaced ? normalize(lightPosition[i].xyz - place) : -lightNormal[i];
        sum += max(0.0, dot(to, n)) * lightDiffuse[i];
    }
    vertColor = vec4(sum, 1.0) * color;
    vertTexCoord = texMatrix * vec4(texCoord, 1.0, 1.0);
}

// Light per vertex, for the front and for the back of a face (its normal reversed). Eye space.
// The halfway vector of the highlight is Blinn's; the highlight does not ask whether the face is
// turned to the light.
const int MOST_LIGHTS = 8;
uniform int light_count;
uniform vec4 light_position[MOST_LIGHTS];  // w = 0: directional
uniform vec3 light_direction[MOST_LIGHTS];
uniform vec3 light_ambient[MOST_LIGHTS];
uniform vec3 light_diffuse[MOST_LIGHTS];
uniform vec3 light_specular[MOST_LIGHTS];
uniform vec3 light_falloff[MOST_LIGHTS];   // constant, linear, quadratic
uniform vec2 light_spot[MOST_LIGHTS];      // cosine of the half angle, concentration (0: no cone)

struct Lit {
    vec4 front;
    vec4 back;
};

float falloff(int i, vec3 place) {
    float distance_to_light = length(light_position[i].xyz - place);
    vec3 powers = vec3(1.0, distance_to_light, distance_to_light * distance_to_light);
    return 1.0 / dot(powers, light_falloff[i]);
}

float cone(int i, vec3 to_light) {
    float cosine = dot(-light_direction[i], to_light);
    return cosine <= light_spot[i].x ? 0.0 : pow(cosine, light_spot[i].y);
}

float highlight(vec3 to_light, vec3 view, vec3 normal, float shininess) {
    return pow(max(0.0, dot(normalize(to_light - view), normal)), shininess);
}

Lit light(vec3 place, vec3 normal, vec4 color, vec4 ambient, vec4 specular, vec4 emissive,
          float shininess) {
    vec3 ambient_sum = vec3(0.0);
    vec3 diffuse[2] = vec3[2](vec3(0.0), vec3(0.0));
    vec3 gloss[2] = vec3[2](vec3(0.0), vec3(0.0));
    vec3 view = normalize(place);
    for (int i = 0; i < light_count; i++) {
        bool directional = light_position[i].w == 0.0;
        vec3 to_light = directional ? -light_direction[i]
                                    : normalize(light_position[i].xyz - place);
        float reach = directional ? 1.0 : falloff(i, place);
        ambient_sum += light_ambient[i] * reach;
        if (light_spot[i].y > 0.0) {
            reach *= cone(i, normalize(light_position[i].xyz - place));
        }
        for (int side = 0; side < 2; side++) {
            vec3 n = side == 0 ? normal : -normal;
            diffuse[side] += light_diffuse[i] * reach * max(0.0, dot(to_light, n));
            if (light_specular[i] != vec3(0.0)) {
                gloss[side] += light_specular[i] * reach * highlight(to_light, view, n, shininess);
            }
        }
    }
    vec4 base = vec4(ambient_sum, 0.0) * ambient + vec4(emissive.rgb, 0.0);
    return Lit(base + vec4(diffuse[0], 1.0) * color + vec4(gloss[0], 0.0) * specular,
               base + vec4(diffuse[1], 1.0) * color + vec4(gloss[1], 0.0) * specular);
}

/** The surface's shader: colour of a quantity, soft light, stripes that show fairness, iso-curves, section cut. */

export const VERTEX = /* glsl */ `
out vec3 place;
out vec3 way;
out vec2 parameters;
void main() {
  place = position;
  way = normal;
  parameters = uv;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

export const FRAGMENT = /* glsl */ `
precision highp float;
precision highp sampler2D;
in vec3 place;
in vec3 way;
in vec2 parameters;
layout(location = 0) out vec4 pixel;

uniform int mode;            // 0 plain, 1 real quantity, 2 classes
uniform sampler2D field;     // one number a grid point; 1e38 where there is none
uniform sampler2D colours;   // the colour map, or one colour a class
uniform vec2 range;
uniform float contour;       // distance between contour lines of the quantity; 0: none
uniform vec2 cells;          // grid points in u and v
uniform vec3 front;
uniform vec3 back;
uniform vec3 undefinedColour;
uniform int stripes;         // 0 none, 1 zebra, 2 isophotes, 3 reflection lines, 4 highlight lines
uniform float density;
uniform vec3 light;
uniform float curves;        // iso-curves across each parameter; 0: none
uniform vec4 cut;            // plane: cut.xyz . x > cut.w is cut away
uniform bool clipped;
uniform bool wire;
uniform float shade;         // strength of the light
uniform vec3 towards;        // direction to the eye, orthographic
uniform float faded;
uniform sampler2D face;      // what the loops of a trimmed face leave, over the window that they span
uniform bool trimmed;
uniform sampler2D proof;     // what is proved, refuted and open, over the parameters
uniform bool proving;

const float MISSING = 1e37;

float at(ivec2 i) { return texelFetch(field, ivec2(i.y, i.x), 0).r; }

float line(float x, float width) {
  float slope = max(fwidth(x), 1e-6);
  float away = abs(fract(x - 0.5) - 0.5) / slope;
  return (1.0 - smoothstep(width - 0.5, width + 0.5, away)) * clamp(1.2 - slope * 2.0, 0.0, 1.0);
}

float band(float x) {
  float slope = max(fwidth(x), 1e-6);
  float wave = abs(fract(x) - 0.5) - 0.25;
  return mix(smoothstep(-slope, slope, wave), 0.5, smoothstep(0.35, 0.8, slope));
}

void main() {
  if (clipped && dot(cut.xyz, place) > cut.w) discard;
  if (trimmed && texture(face, parameters).r < 0.5) discard;
  vec3 eye = isOrthographic ? towards : normalize(cameraPosition - place);
  vec3 flatWay = cross(dFdx(place), dFdy(place));
  vec3 normal = dot(way, way) > 0.2 ? normalize(way) : (dot(flatWay, flatWay) > 0.0 ? normalize(flatWay) : eye);
  bool outside = dot(normal, eye) >= 0.0;
  vec3 colour = outside ? front : back;

  if (mode == 1) {
    vec2 x = parameters * (cells - 1.0);
    ivec2 i = ivec2(clamp(floor(x), vec2(0.0), cells - 2.0));
    vec2 f = x - vec2(i);
    float a = at(i), b = at(i + ivec2(1, 0)), c = at(i + ivec2(0, 1)), d = at(i + ivec2(1, 1));
    if (max(max(abs(a), abs(b)), max(abs(c), abs(d))) > MISSING) {
      colour = undefinedColour;
    } else {
      float value = mix(mix(a, b, f.x), mix(c, d, f.x), f.y);
      float share = clamp((value - range.x) / (range.y - range.x), 0.0, 1.0);
      colour = texture(colours, vec2(share * 255.0 / 256.0 + 0.5 / 256.0, 0.5)).rgb;
      if (contour > 0.0) colour = mix(colour, vec3(0.08), 0.55 * line(value / contour, 0.6));
    }
  } else if (mode == 2) {
    float code = at(ivec2(clamp(floor(parameters * (cells - 1.0) + 0.5), vec2(0.0), cells - 1.0)));
    colour = texelFetch(colours, ivec2(int(code + 0.5), 0), 0).rgb;
  }

  if (proving) {
    vec4 said = texture(proof, parameters);
    colour = mix(colour, said.rgb, 0.8 * said.a);
  }

  if (stripes > 0) {
    vec3 n = outside ? normal : -normal;
    vec3 side = normalize(abs(light.z) < 0.95 ? cross(light, vec3(0.0, 0.0, 1.0)) : cross(light, vec3(0.0, 1.0, 0.0)));
    float x = 0.0;
    float seen = 1.0;
    if (stripes == 1) {
      x = acos(clamp(dot(reflect(-eye, n), light), -1.0, 1.0)) / 3.14159265 * density;
    } else if (stripes == 2) {
      x = acos(clamp(dot(n, light), -1.0, 1.0)) / 3.14159265 * density;
    } else {
      // A ceiling of parallel tube lights, three scene lengths off along the light's direction, at equal angles seen from
      // the middle: as many as are asked for from side to side, and none so close to another that they blur to grey.
      vec3 ray = stripes == 3 ? reflect(-eye, n) : n;
      float rise = dot(ray, light);
      vec3 hit = place + ray * ((3.0 - dot(place, light)) / max(rise, 1e-4));
      x = atan(dot(hit, side), 3.0) / 3.14159265 * density;
      seen = smoothstep(0.02, 0.12, rise);
    }
    float dark = band(x) * seen;
    colour = mode == 0 ? mix(vec3(0.96), vec3(0.1), dark) : mix(colour, colour * 0.28, dark);
  }

  float lit = abs(dot(normal, normalize(eye + 0.35 * light)));
  colour *= mix(1.0, 0.62 + 0.42 * lit, shade);
  if (mode == 0 && stripes == 0) colour += 0.10 * pow(lit, 24.0);

  float grid = 0.0;
  if (curves > 0.0) grid = max(line(parameters.x * curves, wire ? 0.75 : 0.5), line(parameters.y * curves, wire ? 0.75 : 0.5));
  if (wire) {
    if (grid < 0.15) discard;
    pixel = vec4(colour * 0.9, 1.0);
  } else {
    pixel = vec4(mix(colour, vec3(0.05, 0.07, 0.1), grid * 0.34), 1.0);
  }
  pixel.rgb = mix(pixel.rgb, vec3(0.5), faded);
}`;

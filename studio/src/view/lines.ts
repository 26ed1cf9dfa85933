/** Lines of any width in pixels, drawn in one call; refilled in place. */

import {
  BufferAttribute, BufferGeometry, Color, DynamicDrawUsage, GLSL3, GreaterDepth, InstancedBufferGeometry, InstancedInterleavedBuffer,
  InterleavedBufferAttribute, Mesh, Points as PointCloud, ShaderMaterial, Vector2, Vector4,
} from "three";

const VERTEX = /* glsl */ `
in vec3 start;
in vec3 end;
uniform vec2 viewport;
uniform float width;
uniform float lift;
out float across;
void main() {
  vec4 a = projectionMatrix * modelViewMatrix * vec4(start, 1.0);
  vec4 b = projectionMatrix * modelViewMatrix * vec4(end, 1.0);
  vec2 p = a.xy / a.w * viewport, q = b.xy / b.w * viewport;
  vec2 along = q - p;
  float size = length(along);
  along = size > 1e-6 ? along / size : vec2(1.0, 0.0);
  vec2 side = vec2(-along.y, along.x);
  vec4 here = position.x < 0.5 ? a : b;
  float half_ = 0.5 * width + 0.75;
  vec2 shift = side * position.y * half_ + along * (position.x - 0.5) * width;
  across = position.y * half_;
  here.xy += shift / viewport * here.w;
  here.z -= lift * here.w;
  gl_Position = here;
}`;

const FRAGMENT = /* glsl */ `
precision highp float;
in float across;
uniform vec4 colour;
uniform float width;
uniform float veil;
layout(location = 0) out vec4 pixel;
void main() {
  float edge = 1.0 - smoothstep(0.5 * width - 0.25, 0.5 * width + 0.75, abs(across));
  pixel = vec4(colour.rgb, colour.a * veil * edge);
}`;

export class Lines {
  readonly mesh: Mesh;
  private readonly material: ShaderMaterial;
  private readonly behind: Mesh | PointCloud | null;
  private data = new Float32Array(6 * 256);
  private count = 0;
  private geometry: InstancedBufferGeometry;

  /** `hidden` is the share of the opacity that is left where a surface stands before the lines. */
  constructor(colour: string, private readonly width: number, opacity = 1, onTop = false, hidden = 0) {
    const c = new Color().setStyle(colour, "srgb-linear");
    this.material = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader: VERTEX, fragmentShader: FRAGMENT, transparent: true, depthWrite: false, depthTest: !onTop,
      uniforms: {
        viewport: { value: new Vector2(1, 1) }, width: { value: width }, colour: { value: new Vector4(c.r, c.g, c.b, opacity) },
        lift: { value: onTop ? 0 : 4e-4 }, veil: { value: 1 },
      },
    });
    this.geometry = this.allocate();
    this.mesh = new Mesh(this.geometry, this.material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = onTop ? 3 : 2;
    this.behind = hidden ? veiled(this.mesh, this.material, hidden) : null;
  }

  set colour(value: string) {
    const c = new Color().setStyle(value, "srgb-linear");
    const now = this.material.uniforms["colour"]!.value as Vector4;
    now.set(c.r, c.g, c.b, now.w);
  }

  /** Viewport size in pixels, and pixels per CSS pixel. */
  resize(width: number, height: number, ratio: number, lineWidth: number): void {
    (this.material.uniforms["viewport"]!.value as Vector2).set(0.5 * width, 0.5 * height);
    this.material.uniforms["width"]!.value = lineWidth * ratio;
  }

  /** What is drawn, for a picture without WebGL: x, y, z of both ends of each segment, and how. */
  get drawn(): { ends: Float32Array; colour: string; width: number; opacity: number } {
    const { x, y, z, w } = this.material.uniforms["colour"]!.value as Vector4;
    return { ends: this.data.subarray(0, 6 * this.count), colour: `rgb(${[x, y, z].map((c) => Math.round(255 * c)).join(" ")})`, width: this.width, opacity: w };
  }

  begin(): void {
    this.count = 0;
  }

  segment(ax: number, ay: number, az: number, bx: number, by: number, bz: number): void {
    const at = 6 * this.count;
    if (!(ax - ax + ay - ay + az - az + bx - bx + by - by + bz - bz === 0)) return;
    if (at + 6 > this.data.length) {
      const more = new Float32Array(2 * this.data.length);
      more.set(this.data);
      this.data = more;
      this.geometry.dispose();
      this.geometry = this.allocate();
      this.mesh.geometry = this.geometry;
      if (this.behind) this.behind.geometry = this.geometry;
    }
    const d = this.data;
    d[at] = ax; d[at + 1] = ay; d[at + 2] = az; d[at + 3] = bx; d[at + 4] = by; d[at + 5] = bz;
    this.count++;
  }

  join(a: readonly number[], b: readonly number[]): void {
    this.segment(a[0]!, a[1]!, a[2]!, b[0]!, b[1]!, b[2]!);
  }

  end(): void {
    this.geometry.instanceCount = this.count;
    this.mesh.visible = this.count > 0;
    const start = this.geometry.getAttribute("start") as InterleavedBufferAttribute;
    start.data.needsUpdate = true;
  }

  dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }

  private allocate(): InstancedBufferGeometry {
    const geometry = new InstancedBufferGeometry();
    const corners = new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, -1, 0, 1, 1, 0, 0, 1, 0]);
    geometry.setAttribute("position", new BufferAttribute(corners, 3));
    const buffer = new InstancedInterleavedBuffer(this.data, 6, 1);
    buffer.setUsage(DynamicDrawUsage);
    geometry.setAttribute("start", new InterleavedBufferAttribute(buffer, 3, 0));
    geometry.setAttribute("end", new InterleavedBufferAttribute(buffer, 3, 3));
    return geometry;
  }
}

/** The same again, faintly, where a surface hides it. */
function veiled(mesh: Mesh | PointCloud, { uniforms, vertexShader, fragmentShader }: ShaderMaterial, veil: number): Mesh | PointCloud {
  const material = new ShaderMaterial({
    glslVersion: GLSL3, vertexShader, fragmentShader, transparent: true, depthWrite: false, depthFunc: GreaterDepth,
    uniforms: { ...uniforms, veil: { value: veil } },
  });
  const behind = mesh instanceof Mesh ? new Mesh(mesh.geometry, material) : new PointCloud(mesh.geometry, material);
  behind.frustumCulled = false;
  behind.renderOrder = mesh.renderOrder;
  mesh.add(behind);
  return behind;
}

const POINT_VERTEX = /* glsl */ `
in vec4 tint;
uniform float size;
uniform float lift;
out vec4 shade_;
void main() {
  shade_ = tint;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_Position.z -= lift * gl_Position.w;
  gl_PointSize = size * (tint.a > 1.5 ? 1.45 : 1.0);
}`;

const POINT_FRAGMENT = /* glsl */ `
precision highp float;
in vec4 shade_;
uniform float size;
uniform vec3 rim;
uniform float ring;
uniform float veil;
layout(location = 0) out vec4 pixel;
void main() {
  float big = shade_.a > 1.5 ? size * 1.45 : size;
  float r = length(gl_PointCoord - 0.5) * big;
  float edge = 0.5 * big - 0.5;
  float inside = 1.0 - smoothstep(edge - 1.0, edge, r);
  if (inside < 0.02) discard;
  float hollow = shade_.a < 0.75 ? 1.0 : 0.0;
  float core = ring > 0.0 ? 1.0 - smoothstep(edge - ring * big - 0.5, edge - ring * big + 0.5, r) : 1.0;
  vec3 colour = mix(rim, mix(shade_.rgb, rim, hollow), core);
  colour = mix(colour, shade_.rgb, hollow * (1.0 - core));
  pixel = vec4(colour, veil * inside * (hollow > 0.5 ? 0.75 : 1.0));
}`;

/** Round points of a size in pixels, the larger ones with a rim, one colour each. */
export class Points {
  readonly mesh: PointCloud;
  private readonly material: ShaderMaterial;
  private readonly geometry = new BufferGeometry();

  constructor(onTop = false, private readonly across = 11) {
    this.material = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader: POINT_VERTEX, fragmentShader: POINT_FRAGMENT, transparent: true, depthTest: !onTop, depthWrite: false,
      uniforms: { size: { value: 10 }, lift: { value: 2e-3 }, veil: { value: 1 }, rim: { value: new Color(1, 1, 1) }, ring: { value: across < 8 ? 0 : 0.22 } },
    });
    this.mesh = new PointCloud(this.geometry, this.material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = onTop ? 5 : 4;
    if (!onTop) veiled(this.mesh, this.material, 0.3);
  }

  resize(ratio: number): void {
    this.material.uniforms["size"]!.value = this.across * ratio;
  }

  /** What is drawn, for a picture without WebGL: places, and colours with kinds. */
  get drawn(): { places: ArrayLike<number>; tints: ArrayLike<number> } {
    const numbers = (name: string) => this.geometry.getAttribute(name)?.array ?? [];
    return { places: numbers("position"), tints: numbers("tint") };
  }

  /** Place points (x, y, z) with colours (r, g, b, kind): kind 1 plain, 2 selected, 0.5 hollow. */
  fill(positions: readonly (readonly number[])[], tints: readonly (readonly number[])[]): void {
    this.geometry.setAttribute("position", new BufferAttribute(Float32Array.from(positions.flat()), 3));
    this.geometry.setAttribute("tint", new BufferAttribute(Float32Array.from(tints.flat()), 4));
    this.mesh.visible = positions.length > 0;
  }

  dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}

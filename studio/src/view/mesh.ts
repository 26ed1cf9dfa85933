/** The drawn surface: one set of buffers a resolution, filled again and again from a `Grid`, and its material. */

import {
  BufferAttribute, BufferGeometry, CanvasTexture, DataTexture, DoubleSide, DynamicDrawUsage, FloatType, GLSL3, LinearFilter, Mesh,
  NearestFilter, RedFormat, RGBAFormat, ShaderMaterial, UnsignedByteType, Vector2, Vector3, Vector4,
} from "three";
import { THRESHOLDS } from "../numerics/classify";
import { Grid, PLANE } from "../numerics/kernel";
import { QUANTITY } from "../numerics/quantity";
import type { Surface } from "../numerics/surface";
import { coverage, windowOf } from "../numerics/trim";
import { bytes, classColours, mapColours, type Rgb } from "../ui/colours";
import type { Frame } from "./frame";
import { proofTexture, type Regions } from "./proof";
import { FRAGMENT, VERTEX } from "./shader";

const MISSING = 1e38;

interface Buffers {
  readonly geometry: BufferGeometry;
  readonly position: Float32Array;
  readonly normal: Float32Array;
  readonly values: Float32Array<ArrayBuffer>;
  readonly texture: DataTexture;
}

const mapTextures = new Map<string, DataTexture>();

export class SurfaceMesh {
  readonly grid = new Grid();
  readonly material: ShaderMaterial;
  readonly mesh: Mesh;
  /** Values of the drawn quantity at the grid points; NaN where there is none. */
  values = new Float32Array(0);
  /** Grows with every change of the values, so that what follows from them is worked out once. */
  version = 0;
  /** 1 at grid points on the face, 0 at those that its loops cut off. */
  covered: Uint8Array = new Uint8Array(0);
  /** 1 where a grid point stands where one before it does: a pole is one point, however many grid points it takes. */
  repeated = new Uint8Array(0);
  /** How many places the grid has, and how many of them are singular. */
  places = 0;
  singular = 0;
  /** The box around the points in the scene, low and high of x, y, z. */
  readonly box: number[] = [];
  private trim: Surface["trim"];
  private proved: Regions | null = null;
  private counted: { version: number; counts: number[] } | null = null;
  private readonly buffers = new Map<number, Buffers>();
  private current: Buffers | null = null;

  constructor() {
    this.material = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader: VERTEX, fragmentShader: FRAGMENT, side: DoubleSide,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
      uniforms: {
        mode: { value: 0 }, field: { value: null }, colours: { value: null }, range: { value: new Vector2(-1, 1) },
        contour: { value: 0 }, cells: { value: new Vector2(2, 2) }, front: { value: new Vector3() }, back: { value: new Vector3() },
        undefinedColour: { value: new Vector3() }, stripes: { value: 0 }, density: { value: 20 }, light: { value: new Vector3(0, 0, 1) },
        curves: { value: 0 }, cut: { value: new Vector4() }, clipped: { value: false }, wire: { value: false },
        shade: { value: 1 }, towards: { value: new Vector3(0, 0, 1) }, faded: { value: 0 },
        face: { value: null }, trimmed: { value: false }, proof: { value: null }, proving: { value: false },
      },
    });
    this.mesh = new Mesh(undefined, this.material);
    this.mesh.frustumCulled = false;
  }

  /** Evaluate the surface at n × n points and put points, normals and the quantity into the drawn buffers. */
  update(surface: Surface, n: number, quantity: string, frame: Frame): void {
    const b = (this.current = this.prepare(n));
    const { grid } = this;
    grid.evaluate(surface, n, n);
    this.cut(surface, n);
    const { planes: s, stride, count } = grid;
    this.singular = this.places = 0;
    if (this.repeated.length !== count) this.repeated = new Uint8Array(count);
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity], at = b.position;
    const same = (p: number, q: number) => at[3 * p] === at[3 * q] && at[3 * p + 1] === at[3 * q + 1] && at[3 * p + 2] === at[3 * q + 2];
    this.repeated.fill(0);
    for (let p = 0; p < count; p++) {
      for (let x = 0; x < 3; x++) {
        b.position[3 * p + x] = (s[(PLANE.point + x) * stride + p]! - frame.centre[x]!) * frame.scale;
        const normal = s[(PLANE.normal + x) * stride + p]!;
        b.normal[3 * p + x] = normal === normal ? normal : 0;
        const value = at[3 * p + x]!;
        if (value < low[x]!) low[x] = value;
        if (value > high[x]!) high[x] = value;
      }
      if (!this.covered[p]) continue;
      const again = (p % n > 0 && same(p, p - 1)) || (p >= n && same(p, p - n));
      this.repeated[p] = again ? 1 : 0;
      if (again) continue;
      this.places++;
      const k = s[PLANE.gaussian * stride + p]!;
      if (k !== k) this.singular++;
    }
    this.box.splice(0, 6, ...low, ...high);
    b.geometry.attributes["position"]!.needsUpdate = true;
    b.geometry.attributes["normal"]!.needsUpdate = true;
    this.mesh.geometry = b.geometry;
    this.mesh.visible = true;
    const u = this.material.uniforms;
    u["cells"]!.value.set(n, n);
    this.paint(quantity);
  }

  /** Say what the loops of a trimmed face leave, at the grid points and, more finely, to the shader. */
  private cut(surface: Surface, n: number): void {
    if (this.trim === surface.trim && this.covered.length === n * n) return;
    this.covered = coverage(surface, this.grid.u, this.grid.v);
    const u = this.material.uniforms;
    if (this.trim !== surface.trim) {
      u["face"]!.value?.dispose();
      u["face"]!.value = surface.trim?.length ? faceTexture(surface) : null;
      u["trimmed"]!.value = u["face"]!.value !== null;
    }
    this.trim = surface.trim;
  }

  /** Put another quantity of the surface as last evaluated into the drawn buffers. */
  paint(quantity: string): void {
    const b = this.current;
    this.version++;
    if (!b) return;
    const u = this.material.uniforms, q = QUANTITY[quantity];
    u["mode"]!.value = !q ? 0 : q.colour === "classes" ? 2 : 1;
    this.values = q ? b.values : new Float32Array(0);
    if (q) {
      this.grid.quantity(quantity, b.values, THRESHOLDS);
      const out = b.texture.image.data as Float32Array;
      for (let p = 0; p < out.length; p++) {
        const value = b.values[p]!;
        out[p] = value - value === 0 ? value : MISSING;
      }
      b.texture.needsUpdate = true;
      u["field"]!.value = b.texture;
      u["colours"]!.value = mapTexture(quantity);
    }
  }

  /** Lay the map of a claim over the colours; null takes it away. */
  prove(map: Regions | null): void {
    if (map === this.proved) return;
    this.proved = map;
    const u = this.material.uniforms;
    u["proof"]!.value?.dispose();
    u["proof"]!.value = map?.rectangles.length ? proofTexture(map) : null;
    u["proving"]!.value = u["proof"]!.value !== null;
  }

  /** Draw nothing, until it is updated again. */
  clear(): void {
    this.current = null;
    this.mesh.visible = false;
    this.box.length = 0;
  }

  /** How many places are of each class of the drawn classification. */
  get counts(): readonly number[] {
    if (this.counted?.version === this.version) return this.counted.counts;
    const counts: number[] = [];
    for (let p = 0; p < this.values.length; p++) if (this.covered[p] && !this.repeated[p]) counts[this.values[p]!] = (counts[this.values[p]!] ?? 0) + 1;
    this.counted = { version: this.version, counts };
    return counts;
  }

  /** Vertex positions in the scene, for picking. */
  get position(): Float32Array {
    return this.current?.position ?? new Float32Array(0);
  }

  get side(): number {
    return this.current ? this.grid.nu : 0;
  }

  dispose(): void {
    for (const b of this.buffers.values()) {
      b.geometry.dispose();
      b.texture.dispose();
    }
    for (const name of ["face", "proof"]) this.material.uniforms[name]!.value?.dispose();
    this.material.dispose();
  }

  private prepare(n: number): Buffers {
    const known = this.buffers.get(n);
    if (known) return known;
    // A few resolutions are in use at a time: those while dragging and that at rest.
    if (this.buffers.size > 5) {
      const oldest = this.buffers.keys().next().value!;
      this.buffers.get(oldest)!.geometry.dispose();
      this.buffers.get(oldest)!.texture.dispose();
      this.buffers.delete(oldest);
    }
    const geometry = new BufferGeometry();
    const position = new Float32Array(3 * n * n), normal = new Float32Array(3 * n * n), uv = new Float32Array(2 * n * n);
    for (let i = 0, p = 0; i < n; i++) for (let k = 0; k < n; k++, p += 2) uv.set([i / (n - 1), k / (n - 1)], p);
    const index = new Uint32Array(6 * (n - 1) * (n - 1));
    for (let i = 0, q = 0; i < n - 1; i++) {
      for (let k = 0; k < n - 1; k++) {
        const a = i * n + k;
        index[q++] = a; index[q++] = a + n; index[q++] = a + n + 1;
        index[q++] = a; index[q++] = a + n + 1; index[q++] = a + 1;
      }
    }
    geometry.setIndex(new BufferAttribute(index, 1));
    geometry.setAttribute("position", new BufferAttribute(position, 3).setUsage(DynamicDrawUsage));
    geometry.setAttribute("normal", new BufferAttribute(normal, 3).setUsage(DynamicDrawUsage));
    geometry.setAttribute("uv", new BufferAttribute(uv, 2));
    const texture = new DataTexture(new Float32Array(n * n), n, n, RedFormat, FloatType);
    const made = { geometry, position, normal, values: new Float32Array(n * n), texture };
    this.buffers.set(n, made);
    return made;
  }
}

const FACE_SIDE = 1024; // pixels a side; between them the shader follows the loops by their smoothed edge

/** A trimmed face as a picture over the window of its loops: white on it, black off it. */
function faceTexture(surface: Surface): CanvasTexture {
  const canvas = document.createElement("canvas"), [u0, v0, u1, v1] = windowOf(surface);
  canvas.width = canvas.height = FACE_SIDE;
  const context = canvas.getContext("2d")!;
  context.fillRect(0, 0, FACE_SIDE, FACE_SIDE);
  context.fillStyle = "#ffffff";
  context.beginPath();
  for (const loop of surface.trim!) {
    loop.forEach(([u, v], i) => {
      // Row 0 of the picture is v = 1: textures are turned over when they are handed to the card.
      const at = [(FACE_SIDE * (u! - u0)) / (u1 - u0), FACE_SIDE * (1 - (v! - v0) / (v1 - v0))] as const;
      if (i) context.lineTo(...at);
      else context.moveTo(...at);
    });
    context.closePath();
  }
  context.fill("evenodd");
  const texture = new CanvasTexture(canvas);
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.generateMipmaps = false;
  return texture;
}

/** A vector of the three parts of a colour, 0 to 1. */
export const vector = ([r, g, b]: Rgb): Vector3 => new Vector3(r / 255, g / 255, b / 255);

/** The colours of a quantity as a texture: 256 steps of its map, or one a class. */
function mapTexture(quantity: string): DataTexture {
  const q = QUANTITY[quantity]!;
  const name = q.colour === "classes" ? quantity : q.colour;
  let texture = mapTextures.get(name);
  if (!texture) {
    const colours = q.colour === "classes" ? classColours(quantity) : mapColours(q);
    texture = new DataTexture(bytes(colours), colours.length, 1, RGBAFormat, UnsignedByteType);
    texture.magFilter = texture.minFilter = q.colour === "classes" ? NearestFilter : LinearFilter;
    texture.needsUpdate = true;
    mapTextures.set(name, texture);
  }
  return texture;
}

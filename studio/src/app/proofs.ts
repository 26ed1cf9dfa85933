/** Claims, proved by the server while the page goes on: the verdict in words, and on each patch the map of it. */

import type { Model, Patch } from "../numerics/model";
import { section } from "../ui/controls";
import { css } from "../ui/colours";
import { h } from "../ui/dom";
import { PROOF_COLOURS, type ProofState, type Regions } from "../view/proof";
import type { Host } from "./host";
import type { Store } from "./state";

/** What the server says of a claim; `maps` has one entry a patch. */
export interface Proved {
  readonly verdict: string;
  readonly claim: string;
  readonly unit?: string;
  readonly witness?: { readonly patch: string; readonly u: number; readonly v: number; readonly value: number | null } | null;
  readonly why?: string;
  readonly notes: readonly string[];
  readonly maps: readonly Regions[];
}

const REST = 350; // ms without a change before a claim is proved anew
const CLAIMS = ["regular", "gaussian > 0", "gaussian >= 0", "gaussian <= 0", "mean < 0", "mean > 0", "convex", "k1 <= 0", "k2 >= 0", "curvature_radius >= 30", "curvedness <= 0.1", "draft >= 3 deg", "slope <= 60 deg"];
const WORDS: Readonly<Record<ProofState, string>> = { proved: "holds at all points, proved", refuted: "holds nowhere, proved", open: "open" };

export class Proofs {
  private readonly field = h("input", { type: "text", class: "claim", list: "claims", "aria-label": "Claim", placeholder: "such as gaussian > 0", spellcheck: "false" });
  private readonly said = h("p", { class: "hint", role: "status" }, "Type or choose a claim: it is decided for all points, not at samples.");
  private readonly key = h("ul", { class: "types", hidden: true });
  readonly element: HTMLElement;
  private claim = "";
  private maps = new WeakMap<Patch, Regions>();
  private serial = 0;
  private waiting = 0;

  constructor(private readonly store: Store, private readonly host: Host, private readonly redraw: () => void) {
    this.field.addEventListener("change", () => this.ask(this.field.value.trim()));
    this.key.append(...(Object.keys(WORDS) as ProofState[]).map((state) => {
      const box = h("span", { class: "swatch" });
      box.style.background = css(PROOF_COLOURS[state]);
      return h("li", {}, box, h("span", {}, WORDS[state]));
    }));
    const list = h("datalist", { id: "claims" }, ...CLAIMS.map((value) => h("option", { value })));
    this.element = section("Proof", false, this.field, list, this.said, this.key);
    store.subscribe((now, before) => {
      if (this.claim && (now.model !== before.model || now.moving !== before.moving) && !now.moving) this.later();
    });
  }

  /** The map of a patch, for the claim that is shown; null where there is none yet. */
  of(patch: Patch): Regions | null {
    return this.maps.get(patch) ?? null;
  }

  private ask(claim: string): void {
    this.claim = claim;
    this.maps = new WeakMap();
    this.key.hidden = true;
    this.redraw();
    if (claim) void this.prove();
    else {
      this.serial++;
      this.said.textContent = "No claim: type or choose one.";
    }
  }

  private later(): void {
    clearTimeout(this.waiting);
    this.waiting = window.setTimeout(() => void this.prove(), REST);
  }

  private async prove(): Promise<void> {
    const serial = ++this.serial, { model } = this.store.state;
    this.said.textContent = "Proving …";
    try {
      const found = await this.host.prove!(model, this.claim);
      if (serial === this.serial) this.show(model, found);
    } catch (error) {
      if (serial === this.serial) this.said.textContent = (error as Error).message;
    }
  }

  private show(model: Model, found: Proved): void {
    model.patches.forEach((patch, i) => this.maps.set(patch, found.maps[i] ?? { rectangles: [], states: [] }));
    this.key.hidden = !found.maps.some((map) => map.rectangles.length);
    const at = found.witness, where = at?.patch && model.patches.length > 1 ? `${at.patch}, ` : "";
    const fails = at ? ` at ${where}u = ${Number(at.u.toPrecision(4))}, v = ${Number(at.v.toPrecision(4))}${at.value === null ? "" : `, where it is ${Number(at.value.toPrecision(4))}${found.unit ? ` ${found.unit}` : ""}`}` : "";
    this.said.textContent = [`${found.claim}: ${found.verdict}${fails}.`, found.why ?? "", ...found.notes].filter(Boolean).join(" ");
    this.redraw();
  }
}

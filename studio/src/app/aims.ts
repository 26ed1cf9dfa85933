/** What the model is measured against: a target's points and demands, asked of the server after every change, also while dragging. */

import type { LiveHost } from "./host";
import { activePatch, type State, type Store } from "./state";

/** What is asked for: a file beside the model, and demands on the active patch, one a line. */
export interface Aims {
  readonly target: string;
  readonly align: boolean;
  /** Length¹; null for none. */
  readonly tolerance: number | null;
  readonly demands: string;
}

/** Points of a target with their signed distances from the model, length¹. */
export interface Beside {
  readonly name: string;
  /** How many points the file has, and how many are shown. */
  readonly count: number;
  readonly points: number;
  readonly unit: string;
  readonly places: Float64Array;
  readonly distances: Float64Array;
  /** What 99 of 100 distances are within. */
  readonly reach: number;
  readonly min: number;
  readonly max: number;
  readonly rms: number;
  readonly within: number | null;
  readonly edge: number;
  readonly notes: readonly string[];
}

/** What came of a demand: green where it is met; an error where it is none. */
export interface Light {
  readonly demand: string;
  readonly met?: boolean;
  readonly worst?: number | null;
  readonly unit?: string;
  readonly u?: number | null;
  readonly v?: number | null;
  readonly error: string;
}

export const NO_AIMS: Aims = { target: "", align: false, tolerance: null, demands: "" };

const DRAGGED = 2000, RESTING = 20_000; // points of the target

/** Keeps distances and lights up to date, one question at a time. */
export class Follower {
  private asking = false;
  private asked: Pick<State, "model" | "aims" | "patch" | "moving"> | null = null;

  constructor(private readonly store: Store, private readonly host: LiveHost) {
    store.subscribe((now, before) => {
      if (now.model !== before.model || now.aims !== before.aims || now.patch !== before.patch || now.moving !== before.moving) void this.follow();
    });
  }

  private async follow(): Promise<void> {
    if (this.asking) return; // what changes meanwhile is asked for after the answer
    this.asking = true;
    while (this.behind()) {
      const { model, aims, patch, moving } = (this.asked = this.store.state);
      const most = moving ? DRAGGED : RESTING, name = activePatch(this.store.state).name;
      try {
        const beside = aims.target ? await this.host.beside(model, aims, most) : null;
        const lights = aims.demands.trim() ? await this.host.lights(model, name, aims) : [];
        const now = this.store.state;
        if (now.aims.target === aims.target && now.aims.demands === aims.demands && now.patch === patch) this.store.set({ beside, lights });
      } catch (error) {
        this.store.set({ beside: null, lights: [], message: { kind: "error", text: (error as Error).message } });
      }
    }
    this.asking = false;
  }

  private behind(): boolean {
    const { asked, store: { state } } = this;
    if (!state.aims.target && !state.aims.demands.trim() && !state.beside && !state.lights.length) return false;
    return !asked || asked.model !== state.model || asked.aims !== state.aims || asked.patch !== state.patch || asked.moving !== state.moving;
  }
}

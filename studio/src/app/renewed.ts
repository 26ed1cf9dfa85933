/** What is drawn is worked out anew for patches whose surfaces Python has sent meanwhile. */

import { drawnHere } from "../numerics/builders";
import type { Model } from "../numerics/model";
import type { Store } from "./state";

/** Put equal patches in place of those that Python builds: what hangs on the old ones is forgotten. */
export function renew(store: Store): void {
  const { model, saved } = store.state;
  if (model.patches.every(drawnHere)) return;
  const fresh: Model = { ...model, patches: model.patches.map((patch) => (drawnHere(patch) ? patch : { ...patch })) };
  store.set({ model: fresh, saved: saved === model ? fresh : saved });
}

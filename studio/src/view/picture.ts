/** A picture for a file: the drawn cells with their labels, the legend and a line that says what is shown. */

import type { State } from "../app/state";
import { normalSide } from "../numerics/surface";
import { QUANTITY } from "../numerics/quantity";
import { classColours, css, mapColours } from "../ui/colours";
import type { PictureChoice } from "../ui/dialogs";
import { capital, short, unitText } from "../ui/format";
import type { Range } from "./range";
import type { Cell } from "./cell";

/** Write legend, labels and caption onto the picture. */
export function compose(
  image: HTMLCanvasElement, choice: PictureChoice, state: State, range: Range | null, cells: readonly Cell[], labels: readonly string[], dark: boolean,
): HTMLCanvasElement {
  const context = image.getContext("2d")!;
  const { width, height } = image, em = Math.max(11, Math.min(width, height) / 48);
  context.fillStyle = context.strokeStyle = dark ? "#e8edf3" : "#1c232c";
  context.textBaseline = "middle";
  context.font = `600 ${em}px Helvetica, Arial, sans-serif`;
  const across = cells.length ? Math.max(...cells.map((c) => c.x + c.width)) : 1;
  labels.forEach((label, i) => {
    const cell = cells[i];
    if (cell && label) context.fillText(label, (cell.x / across) * width + em, (cell.y / across) * width + 1.4 * em);
  });
  if (!choice.legend) return image;
  const piece = cells[0]?.pieces[state.patch], surface = piece?.surface;
  const side = surface ? `normal ${normalSide(surface)} Su × Sv` : piece?.curve.length ? (state.settings.comb ? "curvature comb" : "curve") : "no surface";
  context.font = `${0.85 * em}px Helvetica, Arial, sans-serif`;
  context.fillText(`${state.model.name} · ${side}${state.model.unit ? ` · lengths in ${state.model.unit}` : ""}`, em, height - 1.2 * em);
  const q = QUANTITY[state.settings.quantity];
  if (!q || !cells[0]?.pieces.some((one) => one.surface)) return image;
  const unit = unitText(q, state.model.unit), title = `${capital(q.name)}${q.colour === "classes" ? "" : ` ${q.symbol}`}${unit ? ` (${unit})` : ""}`;
  const right = width - em, wide = context.measureText(title).width;
  context.textAlign = "right";
  context.fillText(title, right, 1.4 * em);
  context.textAlign = "left";
  if (range) {
    const top = 2.6 * em, tall = Math.min(14 * em, height * 0.5), x = right - Math.max(4.6 * em, 0.3 * wide);
    const colours = mapColours(q);
    colours.forEach((colour, i) => {
      context.fillStyle = css(colour);
      context.fillRect(x, top + tall * (1 - (i + 1) / colours.length), em, tall / colours.length + 0.6);
    });
    context.fillStyle = dark ? "#e8edf3" : "#1c232c";
    for (let i = 0; i < 5; i++) context.fillText(short(range.low + ((range.high - range.low) * i) / 4, 3), x + 1.4 * em, top + tall * (1 - i / 4));
    return image;
  }
  const colours = classColours(q.key);
  q.classes.slice(1).forEach((name, i) => {
    const y = (2.9 + 1.4 * i) * em;
    context.fillStyle = css(colours[i + 1]!);
    context.fillRect(right - em, y - 0.5 * em, em, em);
    context.fillStyle = dark ? "#e8edf3" : "#1c232c";
    context.textAlign = "right";
    context.fillText(name, right - 1.5 * em, y);
    context.textAlign = "left";
  });
  return image;
}

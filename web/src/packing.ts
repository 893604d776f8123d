// Frames as text: each number's change since the frame before, in whole units, in base 64 with five
// bits per character and as many of them as it takes. A motion changes little from frame to frame.

const kDigits = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';

/** @param units  of the columns, from the first one again where there are more columns */
export function packed(frames: number[][], units: number[]): string {
  let text = '';
  let last: number[] = [];
  for (const frame of frames) {
    const whole = frame.map((value, i) => Math.round(value / units[i % units.length]));
    whole.forEach((value, i) => {
      const change = value - (last[i] ?? 0);
      let left = change < 0 ? -2 * change + 1 : 2 * change;
      do {
        const more = left >= 32 ? 32 : 0;
        text += kDigits[(left % 32) + more];
        left = Math.floor(left / 32);
      } while (left > 0);
    });
    last = whole;
  }
  return text;
}

/** The inverse, to the unit. @param columns  numbers in a frame */
export function unpacked(text: string, columns: number, units: number[]): number[][] {
  const frames: number[][] = [];
  const last = Array<number>(columns).fill(0);
  let column = 0;
  let value = 0;
  let scale = 1;
  for (const digit of text) {
    const bits = kDigits.indexOf(digit);
    value += (bits % 32) * scale;
    scale *= 32;
    if (bits >= 32) continue;
    last[column] += value % 2 ? -(value - 1) / 2 : value / 2;
    value = 0;
    scale = 1;
    if (++column === columns) {
      frames.push(last.map((whole, i) => whole * units[i % units.length]));
      column = 0;
    }
  }
  return frames;
}

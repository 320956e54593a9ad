/** px of the image that a letter of a label takes, and the labels' height. */
const kLetterWidth = 9;
const kHeight = 17;

export interface Label {
  x: number;
  y: number;
  letters: number;
}

/** How many lines each label moves away so that none covers another, in the order given. */
export function labelLevels(labels: Label[]): number[] {
  const levels: number[] = new Array(labels.length).fill(0);
  const order = labels.map((_, index) => index).sort((a, b) => labels[a]!.x - labels[b]!.x);
  const placed: {left: number; right: number; y: number}[] = [];
  for (const index of order) {
    const {x, y, letters} = labels[index]!;
    const right = x + letters * kLetterWidth;
    let level = 0;
    while (placed.some((one) => one.right > x && one.left < right && Math.abs(one.y - (y - level * kHeight)) < kHeight))
      level++;
    levels[index] = level;
    placed.push({left: x, right, y: y - level * kHeight});
  }
  return levels;
}

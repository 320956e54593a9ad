/** A cross that keys move over an image, from pixel to pixel. */

export interface Pixel {
  u: number;
  v: number;
}

/** How a picture lies in its frame on the screen. px of the screen, but `picture` px of the image. */
export interface Lie {
  frame: [number, number];
  /** Left top corner and size of the whole picture before it is enlarged and moved. */
  corner: [number, number];
  size: [number, number];
  picture: [number, number];
  zoom: number;
  pan: [number, number];
}

/** px, with Shift. */
const kLongStep_px = 10;
const kDirections: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** Where an arrow key takes the cross, at most to the picture's border; null: it is no arrow key. */
export function moved(from: Pixel, key: string, long: boolean, picture: [number, number]): Pixel | null {
  const direction = kDirections[key];
  if (!direction) return null;
  const step = long ? kLongStep_px : 1;
  return within({u: from.u + step * direction[0], v: from.v + step * direction[1]}, picture);
}

/** The pixel in the middle of what is seen of the picture. */
export function middleOf(lie: Lie): Pixel {
  const along = (axis: 0 | 1): number =>
    Math.floor(
      ((lie.frame[axis] / 2 - lie.corner[axis] - lie.pan[axis]) / (lie.zoom * lie.size[axis])) * lie.picture[axis],
    );
  return within({u: along(0), v: along(1)}, lie.picture);
}

/** The pan that brings a pixel into the middle of the frame. */
export function panTo(pixel: Pixel, lie: Lie): [number, number] {
  const along = (place: number, axis: 0 | 1): number =>
    lie.frame[axis] / 2 - lie.corner[axis] - (lie.zoom * lie.size[axis] * (place + 0.5)) / lie.picture[axis];
  return [along(pixel.u, 0), along(pixel.v, 1)];
}

export function within(pixel: Pixel, picture: [number, number]): Pixel {
  const clamp = (value: number, size: number): number => Math.min(size - 1, Math.max(0, value));
  return {u: clamp(pixel.u, picture[0]), v: clamp(pixel.v, picture[1])};
}

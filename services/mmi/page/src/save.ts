/** Gives a file to who uses the browser. */
export function saveFile(name: string, content: Blob): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** What is painted on. */
export type Painter = Pick<CanvasRenderingContext2D, 'fillStyle' | 'fillRect' | 'drawImage'>;

/** The drawing on its ground: where it is transparent, other programs would show it on theirs. */
export function paintOnGround(painter: Painter, drawing: HTMLCanvasElement, ground: string): void {
  painter.fillStyle = ground;
  painter.fillRect(0, 0, drawing.width, drawing.height);
  painter.drawImage(drawing, 0, 0);
}

/** Gives a drawing as PNG, on a ground of this colour. */
export function savePng(name: string, drawing: HTMLCanvasElement, ground: string): void {
  const canvas = document.createElement('canvas');
  canvas.width = drawing.width;
  canvas.height = drawing.height;
  paintOnGround(canvas.getContext('2d')!, drawing, ground);
  canvas.toBlob((blob) => {
    if (blob) saveFile(name, blob);
  });
}

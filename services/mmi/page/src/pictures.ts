import {parsePicture, type PictureHeader} from './protocol.js';

/** One image pair, decoded, with the messages of that very frame. */
export interface ShownPicture {
  header: PictureHeader;
  left: ImageBitmap;
  right: ImageBitmap;
}

function decode(jpeg: Uint8Array): Promise<ImageBitmap> {
  return createImageBitmap(new Blob([jpeg as Uint8Array<ArrayBuffer>], {type: 'image/jpeg'}));
}

/** Decodes the newest picture that is asked for; what waits behind it is skipped, and told as such. */
export class PictureDecoder {
  private waiting: ArrayBuffer | null = null;
  private busy = false;

  constructor(
    private readonly show: (picture: ShownPicture) => void,
    private readonly skip: (number: number) => void,
  ) {}

  ask(bytes: ArrayBuffer): void {
    if (this.waiting) this.skip(parsePicture(this.waiting).header.number);
    this.waiting = bytes;
    if (!this.busy) void this.work();
  }

  private async work(): Promise<void> {
    this.busy = true;
    while (this.waiting) {
      const {header, left, right} = parsePicture(this.waiting);
      this.waiting = null;
      try {
        const [left_image, right_image] = await Promise.all([decode(left), decode(right)]);
        this.show({header, left: left_image, right: right_image});
      } catch {
        this.skip(header.number);
      }
    }
    this.busy = false;
  }
}

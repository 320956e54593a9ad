import type {ArmPoints, BusMessage, ChannelFigures, FloorRound, Places, Slot, Stop, Trouble} from './protocol.js';

/** The parts of an update that are not messages of the bus are kept beside them, under names that no channel has. */
export interface Parts {
  arm: ArmPoints;
  places: Places;
  floor: FloorRound;
  troubles: Trouble[];
  stop: Stop;
  figures: Record<string, ChannelFigures>;
  latency: Record<string, number | null>;
}

export function slotId(channel: string, key: string): string {
  return `${channel}\n${key}`;
}

export function partId(name: keyof Parts): string {
  return `@${name}`;
}

/** All that was known at one time: now, or an instant of the past. */
export class Moment {
  /** `now`: us, of the source. */
  constructor(
    readonly now: number,
    private readonly valueOf: (id: string) => unknown,
    private readonly ids: () => Iterable<string>,
  ) {}

  slot(channel: string, key = ''): Slot | null {
    return (this.valueOf(slotId(channel, key)) as Slot | undefined) ?? null;
  }

  message(channel: string, key = ''): BusMessage | null {
    return this.slot(channel, key)?.message ?? null;
  }

  /** All that a channel's writers said, by key. */
  slots(channel: string): Slot[] {
    const begin = `${channel}\n`;
    const found: Slot[] = [];
    for (const id of this.ids()) {
      const slot = id.startsWith(begin) ? (this.valueOf(id) as Slot | undefined) : undefined;
      if (slot) found.push(slot);
    }
    return found.sort((a, b) => (a.key < b.key ? -1 : 1));
  }

  part<Name extends keyof Parts>(name: Name): Parts[Name] | null {
    return (this.valueOf(partId(name)) as Parts[Name] | undefined) ?? null;
  }
}

// Packets of the bus that get lost on this network.
import {run} from './process.mjs';

/** `match`: which, as nft says it. */
export function lose(match) {
  return run(['nft', 'add table inet lossy; add chain inet lossy input { type filter hook input priority 0; }; '
    + `add rule inet lossy input udp dport 7667 ${match} drop`]);
}

export function loseNothing() {
  return run(['nft', 'delete table inet lossy'], {may_fail: true});
}

/** The first fragment of what is sent on `channel`, which is too large for one packet. */
export function fragmentsOf(channel) {
  return `@th,224,${8 * channel.length} 0x${Buffer.from(channel).toString('hex')}`;
}

import {readdirSync, readFileSync, readlinkSync} from 'node:fs';

/** How many UDP sockets the process `pid` has open, in its own network. */
export function udpSocketsOf(pid) {
  const own = new Set(readdirSync(`/proc/${pid}/fd`).flatMap((name) => {
    try {
      const inode = /^socket:\[(\d+)\]$/.exec(readlinkSync(`/proc/${pid}/fd/${name}`))?.[1];
      return inode ? [inode] : [];
    } catch {
      return []; // closed meanwhile
    }
  }));
  const lines = ['udp', 'udp6'].flatMap((name) => readFileSync(`/proc/${pid}/net/${name}`, 'utf8').split('\n').slice(1));
  return lines.filter((line) => own.has(line.trim().split(/\s+/)[9])).length;
}

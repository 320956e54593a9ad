// Hears on the bus, by ../bus_ear, what is said of stops.
import {Process, kRepository} from './process.mjs';
import {must} from './wait.mjs';

export class BusEar {
  constructor() {
    this.heard = [];
    this.rest = '';
    this.process = new Process([`${kRepository}/tests/bench/page/bus_ear`]);
    this.process.child.stdout.on('data', (bytes) => this.take(bytes));
  }

  take(bytes) {
    const lines = (this.rest + bytes).split('\n');
    this.rest = lines.pop();
    for (const line of lines) this.heard.push(JSON.parse(line));
    this.process.said = '';
  }

  listens() {
    return must('an ear on the bus', () => this.heard.some((one) => one.listens), 5);
  }

  /** Forgets what it has heard. */
  forget() {
    this.heard = [];
  }

  /** The first STOP, by `source`; null: none yet. */
  stopBy(source) {
    return this.heard.find((one) => one.channel === 'STOP' && one.kind === 'stop' && one.source === source) ?? null;
  }

  /** When each of `devices` first echoed `stop`, latched, ms; null until all have. */
  echoes(stop, devices) {
    const times = devices.map((device) => this.heard.find((one) => one.channel === 'STOP_STATE' && one.device === device
      && one.latched && one.session === stop.session && one.request_id === stop.request_id)?.at_ms);
    return times.every((at_ms) => at_ms !== undefined) ? times : null;
  }

  /** Whether each of `devices` has said that it is free, and nothing else since. */
  free(devices) {
    return devices.every((device) => {
      const last = this.heard.findLast((one) => one.channel === 'STOP_STATE' && one.device === device);
      return last !== undefined && !last.latched;
    });
  }

  end() {
    return this.process.end();
  }
}

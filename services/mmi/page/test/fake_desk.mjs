// Where an invented robot's commands come in, by the rules of services/mmi/README.md as far as a page can meet them.

const kLasts_ms = 5000;
const kTaskLasts_ms = 4000;
let sessions = 1000;
let holder = 0;
let since = '0';
let heard_ms = 0;
let task_until_ms = 0;

function why(latched) {
  const stopped = latched ? 'stopped (arm: page: stopped by hand on the page): reset releases it' : '';
  const busy = Date.now() < task_until_ms ? 'a task is under way (SERVO): abort ends it' : '';
  const moves = stopped || busy;
  return {
    start: moves,
    home: moves,
    drive: moves,
    reset: latched ? '' : 'nothing is stopped',
    abort: busy ? '' : 'no task is under way',
  };
}

/** One client's side of it. `robot`: {latched(), reset()}. */
export class FakeDesk {
  session = ++sessions;
  answers = [];
  told = '';
  newest = 0;
  may = false;

  constructor(robot) {
    this.robot = robot;
  }

  hear(message, now_us) {
    if (message.type === 'hello') this.may = message.token === 'fake';
    if (message.type === 'lease') this.lease(message, now_us);
    if (message.type === 'command') this.command(message, now_us);
  }
  /** What an update tells of it. */
  parts() {
    if (Date.now() - heard_ms > kLasts_ms) holder = 0;
    const desk = {
      session: String(this.session),
      may: this.may,
      holder: holder === 0 ? 'none' : holder === this.session ? 'you' : 'another',
      since: holder === 0 ? '0' : since,
      targets: ['blue_book', 'red_book'],
      why: why(this.robot.latched()),
    };
    const text = JSON.stringify(desk);
    const parts = text === this.told ? {} : {desk};
    this.told = text;
    if (this.answers.length > 0) parts.answers = this.answers.splice(0);
    return parts;
  }
  leave() {
    if (holder === this.session) holder = 0;
  }

  lease({on, take}, now_us) {
    if (!this.may) return;
    if (!on) return this.leave();
    if (holder !== 0 && holder !== this.session && !take) return;
    if (holder !== this.session) since = String(now_us);
    holder = this.session;
    heard_ms = Date.now();
  }
  command(message, now_us) {
    const left_us = Number(message.expires) - now_us;
    const refused = (code, text) => this.answers.push({seq: message.seq, state: 'refused', code, text});
    if (!this.may) return refused('no_token', '');
    if (holder !== this.session) return refused('no_lease', '');
    if (message.session !== String(this.session)) return refused('other_session', '');
    if (message.seq <= this.newest) return refused('replayed', '');
    this.newest = message.seq;
    if (left_us < 0 || left_us > 2e6) return refused(left_us < 0 ? 'expired' : 'too_far_ahead', `${left_us} us`);
    const reason = why(this.robot.latched())[message.kind === 'carry' ? 'start' : message.kind];
    if (reason) return refused('cannot', reason);
    this.obey(message);
  }
  obey(message) {
    console.log('obeyed', JSON.stringify(message));
    const tell = (state, text, ms) => setTimeout(() => this.answers.push({seq: message.seq, state, code: '', text}), ms);
    tell('sent', '', 0);
    if (message.kind === 'reset') this.robot.reset();
    if (message.kind === 'reset' || message.kind === 'abort') {
      task_until_ms = 0;
      tell('done', message.kind === 'reset' ? 'reset: arm, base' : 'aborted', 200);
      return;
    }
    task_until_ms = Date.now() + kTaskLasts_ms;
    tell('under_way', 'SERVO', 300);
    tell('done', message.kind === 'home' ? 'home' : 'lifted', kTaskLasts_ms);
  }
}

// Plays a page that commands. usage: page_operator.mjs RUNTIME_DIR job|hostile|two|again
import {readFileSync} from 'node:fs';
import {WebSocketPeer} from '../bench/page/web_socket.mjs';

const [folder, part] = process.argv.slice(2);
const kToken = readFileSync(`${folder}/page.token`, 'utf8').trim();
const kPatience_ms = 90_000;
const kEchoed_ms = 500;

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

function fail(why) {
  console.log(`        ${why}`);
  process.exit(1);
}

async function until(what, condition, patience_ms = kPatience_ms) {
  for (const begin = Date.now(); !condition(); await pause(10)) {
    if (Date.now() - begin > patience_ms) fail(`not within ${patience_ms / 1000} s: ${what}`);
  }
}

class Page {
  constructor(token) {
    this.answers = [];
    this.seq = 0;
    this.desk = null;
    this.stop = null;
    this.now_us = 0n;
    this.ended = false;
    this.ready = new Promise((resolve) => {
      this.peer = new WebSocketPeer({path: `${folder}/page.sock`}, resolve, (isText, payload) => this.hear(isText, payload),
        () => (this.ended = true));
    });
    this.ready.then(() => this.peer.say({type: 'hello', protocol: 1, token}));
  }

  hear(isText, payload) {
    if (!isText) return;
    const message = JSON.parse(payload.toString());
    if (message.type !== 'update') return;
    this.peer.say({type: 'took', number: message.number});
    this.now_us = BigInt(message.now);
    this.desk = message.desk ?? this.desk;
    this.stop = message.stop ?? this.stop;
    for (const answer of message.answers ?? []) this.answers.push({...answer, at_ms: Date.now()});
  }

  async known() {
    await until('desk', () => this.desk !== null);
    return this;
  }
  async operates(take = false) {
    await this.known();
    this.peer.say({type: 'lease', on: true, take});
    this.lease ??= setInterval(() => !this.ended && this.peer.say({type: 'lease', on: true}), 1000);
    await until('the lease', () => this.desk.holder === 'you', 5000);
    return this;
  }

  send(kind, {seq = ++this.seq, expires_us = this.now_us + 1_500_000n, session = this.desk.session, ...more} = {}) {
    this.peer.say({type: 'command', session, seq, expires: String(expires_us), kind, ...more});
    return seq;
  }
  answersTo(seq) {
    return this.answers.filter((answer) => answer.seq === seq);
  }
  /** The answer that ends it. */
  async ending(seq) {
    const last = () => this.answersTo(seq).find(({state}) => !['sent', 'under_way'].includes(state));
    await until(`an ending of ${seq}`, () => last() !== undefined);
    return last();
  }
  async can(kind) {
    await until(`${kind} is possible, not: ${this.desk.why[kind]}`, () => this.desk.why[kind] === '');
  }

  /** Does it, as a person who waits until the button works. Says so where it was not echoed in time. */
  async does(kind, more = {}) {
    await this.can(kind === 'carry' ? 'start' : kind);
    const asked_ms = Date.now();
    const seq = this.send(kind, more);
    const ending = await this.ending(seq);
    if (ending.state !== 'done') fail(`${kind}: ${ending.state} ${ending.code} ${ending.text}`);
    const echo = this.answersTo(seq).find(({state}) => state !== 'sent');
    if (echo.at_ms - asked_ms > kEchoed_ms) fail(`${kind}: echoed after ${echo.at_ms - asked_ms} ms`);
  }
  async isRefused(code, kind, more) {
    const before = this.answers.length;
    this.send(kind, more);
    await until(`an answer to ${kind}`, () => this.answers.length > before, 5000);
    const answer = this.answers[before];
    if (answer.state !== 'refused' || answer.code !== code) fail(`${kind} ${code}: ${JSON.stringify(answer)}`);
  }
  end() {
    clearInterval(this.lease);
    this.peer.vanish();
  }
}

const parts = {
  async job() {
    const page = await new Page(kToken).operates();
    await page.does('reset');
    await page.does('start', {target: 'red_book'});
    page.peer.say({type: 'stop', reason: 'a test'});
    await until('acknowledged', () => page.stop?.state === 'acknowledged');
    if (page.desk.why.start === '') await until('start says why', () => page.desk.why.start !== '');
    await page.does('reset');
    await page.does('home');
    await page.does('drive', {place: [0.2, 0.95, 1.5708]});
    page.end();
  },

  async hostile() {
    const stranger = await new Page('a guess').known();
    if (stranger.desk.may) fail('a guess is no token');
    stranger.peer.say({type: 'lease', on: true, take: true});
    await stranger.isRefused('no_token', 'home');
    const page = await new Page(kToken).known();
    await page.isRefused('no_lease', 'home');
    await page.operates();
    const now_us = page.now_us;
    await page.isRefused('expired', 'home', {expires_us: now_us - 1n});
    await page.isRefused('too_far_ahead', 'home', {expires_us: now_us + 60_000_000n});
    await page.isRefused('replayed', 'home', {seq: 1});
    await page.isRefused('other_session', 'home', {session: '12345'});
    await page.isRefused('unknown_target', 'start', {target: 'no_such_book'});
    await page.isRefused('cannot', 'reset');
    if (page.answers.some(({state}) => state !== 'refused')) fail('something was sent');
    page.peer.sayText('{"type":"command","session":1}');
    await until('a malformed command ends the connection', () => page.ended, 5000);
    stranger.end();
    page.end();
  },

  async two() {
    const first = await new Page(kToken).operates();
    const second = await new Page(kToken).known();
    await until('the second sees the first', () => second.desk.holder === 'another', 5000);
    await second.isRefused('no_lease', 'abort');
    await second.operates(true);
    await until('the first sees that', () => first.desk.holder === 'another', 5000);
    await first.isRefused('no_lease', 'home');
    second.end();
    await until('its lease ends', () => first.desk.holder !== 'another', 7000);
    first.end();
  },

  async again() {
    const page = await new Page(kToken).operates();
    await page.isRefused('other_session', 'home', {session: '12345'});
    await page.does('home');
    page.end();
  },
};

await parts[part]();
process.exit(0);

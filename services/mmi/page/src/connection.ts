import type {Hello, Stop, ToServer, Update} from './protocol.js';

export type Life = 'open' | 'silent' | 'lost';

export interface Hearer {
  onHello(hello: Hello): void;
  onUpdate(update: Update): void;
  onPicture(bytes: ArrayBuffer): void;
  onLife(life: Life, why: string): void;
  /** A Stop has failed. */
  onStopFate(): void;
}

/** What this page speaks, of services/mmi/README.md. */
const kProtocol = 1;

export interface ConnectionParameters {
  /** ms without any message after which the page is greyed: mmi speaks every 250 ms, and 1 s is what is promised. */
  silence_ms: number;
  /** ms without any message after which the socket is given up for a new one. */
  give_up_ms: number;
  /** ms without a hello after which a new socket is given up; after each that was, the next may take twice as long. */
  hello_ms: number;
  /** ms, at most: a log of many events says a hello that takes its time on a slow link. */
  hello_most_ms: number;
  /** ms between two tries. */
  retry_ms: number;
  /** ms after which a Stop that nobody has answered is no longer sent: nobody expects it any more. */
  stop_valid_ms: number;
}

export const kConnectionParameters: ConnectionParameters = {
  silence_ms: 800,
  give_up_ms: 3000,
  hello_ms: 5000,
  hello_most_ms: 60000,
  retry_ms: 400,
  stop_valid_ms: 10000,
};

/** ms; a page that slept longer between two looks has not waited all that time. */
const kLongestWait_ms = 1000;

/** What became of the newest Stop: no socket could take it yet, it went out without an answer yet, nobody answered it. */
export type StopFate = 'waiting' | 'sent' | 'failed';

/** The socket to mmi, opened anew whenever it is lost. */
export class Connection {
  private socket: WebSocket | null = null;
  private heard_ms = 0;
  private watched_ms = 0;
  private life: Life = 'lost';
  /** Until mmi tells of it: a socket takes what nobody reads. */
  private stop_wanted: {reason: string; at_ms: number; sent: boolean; beside: string} | null = null;
  private stop_failed = false;
  /** The newest request that mmi has told of, and its state. */
  private stop_told = '';
  /** mmi wants a token that we do not have, or speaks another protocol: it lets us stop, and nothing else. */
  private only_stop = false;
  /** It has said hello. */
  private greeted = false;
  /** ms that this socket has been waited for to say hello, and how long that may take. */
  private awaited_ms = 0;
  private patience_ms: number;
  /** mmi has promised never to be silent for long: silence means that it is lost. */
  private speaks_always = false;
  private pictures_on = false;
  private looked: string[] = [];
  private retry: number | undefined;

  constructor(
    private readonly url: string,
    private token: string | null,
    private readonly hearer: Hearer,
    private readonly parameters: ConnectionParameters = kConnectionParameters,
  ) {
    this.patience_ms = parameters.hello_ms;
  }

  start(): void {
    this.watched_ms = performance.now();
    this.open();
    setInterval(() => this.watch(), 100);
  }

  /** STOP, at once or as soon as there is a socket again. False: it could not be sent yet. */
  stop(reason: string): boolean {
    this.stop_wanted = {reason, at_ms: performance.now(), sent: false, beside: this.stop_told};
    this.stop_failed = false;
    if (this.only_stop && !this.socket) this.open();
    return this.sendStop();
  }

  /** Speaks with another token from now on: mmi may grant what it has refused. */
  useToken(token: string): void {
    if (token === this.token) return;
    this.token = token;
    this.only_stop = false;
    this.openAnew('');
  }

  /** Null: none is under way, or mmi has told of it. */
  get stopFate(): StopFate | null {
    if (this.stop_failed) return 'failed';
    if (!this.stop_wanted) return null;
    return this.stop_wanted.sent ? 'sent' : 'waiting';
  }

  pictures(on: boolean): void {
    if (on === this.pictures_on) return;
    this.pictures_on = on;
    this.send({type: 'pictures', on});
  }

  look(channels: string[]): void {
    const sorted = [...new Set(channels)].sort();
    if (sorted.join() === this.looked.join()) return;
    this.looked = sorted;
    this.send({type: 'look', channels: sorted});
  }

  send(message: ToServer): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    if (this.only_stop && message.type !== 'stop') return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }

  private open(): void {
    clearTimeout(this.retry);
    this.speaks_always = false;
    this.greeted = false;
    this.awaited_ms = 0;
    const socket = new WebSocket(this.url);
    socket.binaryType = 'arraybuffer';
    this.socket = socket;
    this.heard_ms = performance.now();
    socket.onopen = () => this.onOpen(socket);
    socket.onmessage = (event) => this.onMessage(socket, event);
    socket.onclose = (event) => this.onClose(socket, event);
  }

  private onOpen(socket: WebSocket): void {
    if (socket !== this.socket) return;
    this.heard_ms = performance.now();
    this.sendStop();
    if (this.only_stop) return;
    if (this.token !== null) this.send({type: 'hello', protocol: kProtocol, token: this.token});
    else this.send({type: 'hello', protocol: kProtocol});
    if (this.looked.length > 0) this.send({type: 'look', channels: this.looked});
    if (this.pictures_on) this.send({type: 'pictures', on: true});
  }

  private onMessage(socket: WebSocket, event: MessageEvent): void {
    if (socket !== this.socket) return;
    this.heard_ms = performance.now();
    if (event.data instanceof ArrayBuffer) {
      this.hearer.onPicture(event.data);
      return;
    }
    const message = JSON.parse(event.data as string) as {type: string};
    if (message.type === 'hello') this.onHello(message as Hello);
    else if (message.type === 'update') this.onUpdate(message as Update);
    if (this.greeted) this.tell('open', '');
  }

  private onHello(hello: Hello): void {
    if (hello.protocol !== kProtocol) {
      this.refuse(`it speaks protocol ${hello.protocol}, this page ${kProtocol}: reload the page`);
      return;
    }
    this.greeted = true;
    this.patience_ms = this.parameters.hello_ms;
    this.speaks_always = hello.update_at_least_every !== undefined;
    this.hearer.onHello(hello);
  }

  private onUpdate(update: Update): void {
    if (update.number !== undefined) this.send({type: 'took', number: update.number});
    if (update.stop) this.onStop(update.stop);
    this.hearer.onUpdate(update);
  }

  /** A Stop beside one that is under way is the same request; any other is a new one. */
  private onStop(stop: Stop): void {
    this.stop_told = `${stop.request ?? ''} ${stop.state}`;
    const wanted = this.stop_wanted;
    if (!wanted?.sent || stop.state === 'idle') return;
    if (this.stop_told !== wanted.beside || stop.state === 'requested') this.stop_wanted = null;
  }

  private onClose(socket: WebSocket, event: CloseEvent): void {
    if (socket !== this.socket) return;
    this.socket = null;
    const refused = /token|protocol/i.test(event.reason);
    if (refused) this.only_stop = true;
    if (refused || !this.only_stop) this.tell('lost', event.reason);
    // Without a token a socket is opened for a Stop alone.
    if (this.only_stop && (!this.stop_wanted || this.stop_wanted.sent)) return;
    this.retry = setTimeout(() => this.open(), this.parameters.retry_ms) as unknown as number;
  }

  private watch(): void {
    const now = performance.now();
    if (this.stop_wanted && now - this.stop_wanted.at_ms > this.parameters.stop_valid_ms) {
      this.stop_failed = !this.only_stop || !this.stop_wanted.sent;
      this.stop_wanted = null;
      this.hearer.onStopFate();
    }
    const passed_ms = now - this.watched_ms;
    // A page that slept (a laptop's lid, a debugger) has not heard because it did not listen.
    if (passed_ms > 500) this.heard_ms = Math.max(this.heard_ms, now - this.parameters.silence_ms / 2);
    this.watched_ms = now;
    this.awaitHello(passed_ms);
    if (!this.speaks_always) return;
    const silence_ms = now - this.heard_ms;
    if (silence_ms > this.parameters.silence_ms && this.life === 'open') this.tell('silent', '');
    if (silence_ms > this.parameters.give_up_ms && this.socket) this.openAnew('');
  }

  /** A handshake may hang for minutes, and a forwarder takes a socket whose other end nobody reads. */
  private awaitHello(passed_ms: number): void {
    // To a Stop alone nobody says hello.
    const awaited = this.only_stop ? this.socket?.readyState !== WebSocket.OPEN : !this.greeted;
    if (!awaited || !this.socket) return;
    this.awaited_ms += Math.min(passed_ms, kLongestWait_ms);
    if (this.awaited_ms <= this.patience_ms) return;
    const why = `no answer within ${this.patience_ms / 1000} s`;
    this.patience_ms = Math.min(2 * this.patience_ms, this.parameters.hello_most_ms);
    this.openAnew(why);
  }

  private openAnew(why: string): void {
    this.giveUp();
    this.tell('lost', why);
    if (!this.only_stop || this.stop_wanted) this.open();
  }

  /** What comes from this socket is no longer heard. */
  private giveUp(): void {
    const given_up = this.socket;
    this.socket = null;
    given_up?.close();
  }

  /** We do not understand each other, and will not by trying again; Stop is understood before hello. */
  private refuse(why: string): void {
    this.only_stop = true;
    this.speaks_always = false;
    this.giveUp();
    this.tell('lost', why);
  }

  private sendStop(): boolean {
    const wanted = this.stop_wanted;
    if (!wanted) return true;
    wanted.sent = this.send({type: 'stop', reason: wanted.reason});
    return wanted.sent;
  }

  private tell(life: Life, why: string): void {
    if (life === this.life && why === '') return;
    this.life = life;
    this.hearer.onLife(life, why);
  }
}

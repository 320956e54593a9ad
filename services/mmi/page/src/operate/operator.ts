import type {Life} from '../connection.js';
import type {Pose} from '../drawing/geometry.js';
import {microseconds} from '../format.js';
import type {CommandKind, CommandWord, Desk, LeaseWord, Update} from '../protocol.js';
import {AnswerList} from './answer_list.js';
import {whyNoControl, whyNot, type CommandFacts} from './command_reasons.js';
import {CommandStamps} from './command_stamps.js';
import {LeaseKeeper} from './lease_keeper.js';
import {MmiClock} from './mmi_clock.js';
import {placeWords} from './wished_place.js';

/**
 * What this page commands. What cannot be sent at once is not sent at all, and nothing twice: each command is of one
 * conversation. All times are ms of performance.now().
 */
export class Operator {
  /** mmi lets commands in. */
  enabled = false;
  /** Of this conversation; null until mmi has told it. */
  desk: Desk | null = null;
  /** Where the robot shall drive, X_WR. */
  wished: Pose | null = null;
  readonly answers = new AnswerList();
  private readonly lease = new LeaseKeeper();
  private readonly clock = new MmiClock();
  private readonly stamps = new CommandStamps();
  private open = false;
  private greeted = false;

  /** `send`: false when it could not; `changed`: what is shown of all this is to be drawn anew. */
  constructor(
    private readonly send: (word: LeaseWord | CommandWord) => boolean,
    private readonly changed: () => void,
  ) {}

  /** Who holds the lease. Of one that this page no longer keeps it takes no notice. */
  get holder(): Desk['holder'] {
    const told = this.desk?.holder ?? 'none';
    return told === 'you' && !this.lease.holds ? 'none' : told;
  }

  get loss(): LeaseKeeper['loss'] {
    return this.lease.loss;
  }

  onHello(): void {
    this.endConversation();
    this.greeted = true;
  }

  onUpdate(update: Update, at_ms: number): void {
    this.clock.observe(microseconds(update.now), at_ms);
    // Of the desk all is told with the first update.
    if (this.greeted) this.enabled = update.desk !== undefined;
    const first = this.greeted;
    this.greeted = false;
    if (update.desk) {
      this.desk = update.desk;
      this.lease.observe(update.desk.holder, at_ms);
    }
    if (update.answers) this.answers.observe(update.answers);
    if (first || update.desk || update.answers) this.changed();
  }

  onLife(life: Life): void {
    this.open = life === 'open';
    if (life === 'lost') this.endConversation();
    this.changed();
  }

  /** To be called some times a second, and when the page becomes `visible` or hidden. */
  step(at_ms: number, visible: boolean): void {
    const loss = this.lease.loss;
    const word = this.lease.step(at_ms, visible);
    if (word) this.send(word);
    if (this.answers.step(at_ms) || this.lease.loss !== loss) this.changed();
  }

  whyNoControl(): string {
    return whyNoControl(this.facts(null));
  }

  whyNot(kind: CommandKind, selected: string | null): string {
    return whyNot(kind, this.facts(selected));
  }

  /** Takes control, gives it up, or, where another operates, takes it over. */
  toggleControl(at_ms: number): void {
    if (this.whyNoControl() !== '') return;
    const holder = this.holder;
    this.send(holder === 'you' ? this.lease.giveUp() : this.lease.ask(holder === 'another', at_ms));
    this.changed();
  }

  wish(place: Pose | null): void {
    this.wished = place;
    this.changed();
  }

  /** False: it cannot work, or there is no socket, and nothing was sent. */
  command(kind: CommandKind, selected: string | null, at_ms: number): boolean {
    const now_us = this.clock.at(at_ms);
    if (!this.desk || now_us === null || this.whyNot(kind, selected) !== '') return false;
    const word: CommandWord = {type: 'command', ...this.stamps.next(this.desk.session, now_us), kind};
    if (kind === 'start' || kind === 'carry') word.target = selected!;
    if (kind === 'drive') word.place = [this.wished!.x, this.wished!.y, this.wished!.heading];
    if (!this.send(word)) return false;
    this.answers.add(word.seq, kind, this.wordsOf(word), at_ms);
    this.changed();
    return true;
  }

  private facts(selected: string | null): CommandFacts {
    return {
      open: this.open,
      desk: this.desk,
      holds: this.lease.holds,
      waiting: this.answers.waiting,
      selected,
      place: this.wished,
    };
  }

  private wordsOf(word: CommandWord): string {
    if (word.kind === 'start') return `Start: ${word.target}`;
    if (word.kind === 'carry') return `Start and carry: ${word.target}`;
    if (word.kind === 'drive') return `Drive to ${placeWords(this.wished!)}`;
    return {abort: 'Abort', home: 'Home', reset: 'Reset'}[word.kind];
  }

  private endConversation(): void {
    this.desk = null;
    this.clock.forget();
    this.lease.disconnect();
    this.answers.disconnect();
  }
}

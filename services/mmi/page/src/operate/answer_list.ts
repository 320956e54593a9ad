import type {Answer, CommandKind} from '../protocol.js';

/** What became of a command; `waiting`: mmi has not said a word of it. */
export type Fate = 'waiting' | Answer['state'];

export interface Commanded {
  seq: number;
  kind: CommandKind;
  /** What was wished. */
  words: string;
  at_ms: number;
  fate: Fate;
  code: string;
  text: string;
}

const kAtMost = 20;
/** ms; mmi speaks every 250 ms and does nothing 2 s late: who has not heard by then will not. */
const kPatience_ms = 3000;
const kUnknown = 'no answer: it may have been done; look before you try again';
const kOpenFates: Fate[] = ['waiting', 'sent', 'under_way'];

/** What this page has commanded, and what became of it. All times are ms of performance.now(). */
export class AnswerList {
  /** Newest first. */
  entries: Commanded[] = [];
  /** Those of which this conversation may still tell. */
  private told = new Map<number, Commanded>();

  add(seq: number, kind: CommandKind, words: string, at_ms: number): void {
    const entry: Commanded = {seq, kind, words, at_ms, fate: 'waiting', code: '', text: ''};
    this.entries = [entry, ...this.entries].slice(0, kAtMost);
    this.told.set(seq, entry);
  }

  observe(answers: Answer[]): void {
    for (const answer of answers) {
      const entry = this.told.get(Number(answer.seq));
      if (!entry) continue;
      entry.fate = answer.state;
      entry.code = answer.code;
      entry.text = answer.text;
      if (!kOpenFates.includes(entry.fate)) this.told.delete(entry.seq);
    }
  }

  /** Whether anything changed. */
  step(at_ms: number): boolean {
    const late = this.entries.filter((entry) => entry.fate === 'waiting' && at_ms - entry.at_ms > kPatience_ms);
    for (const entry of late) entry.fate = 'unanswered';
    return late.length > 0;
  }

  /** The conversation is over: no answer comes any more. */
  disconnect(): void {
    for (const entry of this.told.values()) {
      if (!kOpenFates.includes(entry.fate)) continue;
      entry.text = entry.fate === 'under_way' ? 'it was under way, and goes on' : '';
      entry.fate = 'unanswered';
    }
    this.told.clear();
  }

  /** What nobody has taken up yet: mmi refuses more of it. */
  get waiting(): CommandKind[] {
    return this.entries.filter(({fate}) => fate === 'waiting' || fate === 'sent').map(({kind}) => kind);
  }
}

/** What became of it, in words. */
export function fateWords({fate, code, text}: Commanded): string {
  const more = text === '' ? '' : `: ${text}`;
  switch (fate) {
    case 'waiting':
      return 'on its way to mmi';
    case 'refused':
      return `refused (${code}), nothing was sent${more}`;
    case 'sent':
      return `sent to the robot${more}`;
    case 'under_way':
      return `under way${more}`;
    case 'unanswered':
      return text === '' ? kUnknown : `${kUnknown} (${text})`;
    default:
      return `${fate}${more}`;
  }
}

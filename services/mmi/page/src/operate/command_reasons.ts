import type {Pose} from '../drawing/geometry.js';
import type {CommandKind, Desk} from '../protocol.js';

/** What decides whether a command can work. */
export interface CommandFacts {
  /** mmi is heard. */
  open: boolean;
  desk: Desk | null;
  /** The lease is this page's. */
  holds: boolean;
  /** What was commanded and has not been taken up yet. */
  waiting: CommandKind[];
  /** What is selected, a target or not. */
  selected: string | null;
  place: Pose | null;
}

const kMoves: CommandKind[] = ['start', 'carry', 'home', 'drive'];

/** Why this page cannot take control; empty: it can. */
export function whyNoControl(facts: CommandFacts): string {
  if (!facts.open) return 'no connection to mmi';
  if (!facts.desk) return 'mmi has not told yet what can be done';
  return facts.desk.may ? '' : 'no token: open the address that scripts/page printed';
}

/** Why a command cannot work; empty: it can, as far as is known here. */
export function whyNot(kind: CommandKind, facts: CommandFacts): string {
  const no_control = whyNoControl(facts);
  if (no_control !== '' || !facts.desk) return no_control;
  if (!facts.holds) {
    const another = facts.desk.holder === 'another';
    return another ? 'no lease: another operates; take over first' : 'no lease: take control first';
  }
  const moves = kMoves.includes(kind);
  if (facts.waiting.some((other) => other === kind || (moves && kMoves.includes(other)))) {
    return 'the command before it has not been answered yet';
  }
  return facts.desk.why[kind === 'carry' ? 'start' : kind] || whyNoChoice(kind, facts, facts.desk.targets);
}

function whyNoChoice(kind: CommandKind, {selected, place}: CommandFacts, targets: string[]): string {
  if ((kind === 'start' || kind === 'carry') && !targets.includes(selected ?? '')) {
    return selected === null ? 'no target chosen' : `no target chosen: ${selected} is none`;
  }
  if (kind === 'drive' && !place) return 'no place chosen: click on the floor in Drive, or type it there';
  return '';
}

/** Reasons once each, in order, with the names of the buttons that they hold for. */
export function grouped(buttons: {name: string; why: string}[]): {why: string; names: string[]}[] {
  const groups = new Map<string, string[]>();
  for (const {name, why} of buttons) {
    if (why !== '') groups.set(why, [...(groups.get(why) ?? []), name]);
  }
  return [...groups].map(([why, names]) => ({why, names}));
}

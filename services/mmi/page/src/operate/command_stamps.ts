/** us that a command is good for; mmi takes none of more than 2 s, and our clock may be a little off. */
const kLife_us = 1.5e6;

export interface CommandStamp {
  session: string;
  seq: number;
  expires: string;
}

/** The names of commands: of each conversation the first is 1, and none is given twice. */
export class CommandStamps {
  private session = '';
  private seq = 0;

  /** `session`: of this conversation; `now_us`: by mmi's clock. */
  next(session: string, now_us: number): CommandStamp {
    if (session !== this.session) this.seq = 0;
    this.session = session;
    return {session, seq: ++this.seq, expires: String(Math.round(now_us + kLife_us))};
  }
}

// When which trouble was first, by the status line and by /state.json.
import {pause} from './wait.mjs';
import {state} from './state.mjs';

/** Inside the page: notes each change of the status line with what a person can see of it. */
export function watchStatusLine() {
  window.statusLines = [];
  let last = '';
  const note = () => {
    const line = document.querySelector('[data-trouble]');
    if (!line) return;
    const remedy = line.querySelector('.remedy');
    const text = line.querySelector('.trouble-text');
    const box = remedy?.getBoundingClientRect();
    // What is clamped away lies below its own box.
    const clip = text?.getBoundingClientRect();
    const on_screen = !!box && box.right <= innerWidth && box.bottom <= innerHeight;
    const seen = on_screen && box.width > 0 && box.bottom <= clip.bottom + 1;
    const words = {
      code: line.dataset.trouble, subject: line.dataset.subject, remedy: remedy?.textContent ?? '', remedy_seen: seen,
      size_px: text ? parseFloat(getComputedStyle(text).fontSize) : 0,
      text: text?.textContent.trim().slice(0, 400) ?? '',
    };
    const key = `${words.code} ${words.subject}`;
    if (key !== last) window.statusLines.push({at_ms: performance.timeOrigin + performance.now(), ...words});
    else if (seen) window.statusLines.at(-1).remedy_seen = true;
    last = key;
  };
  document.addEventListener('DOMContentLoaded', () => {
    const all = {subtree: true, childList: true, attributes: true, characterData: true};
    new MutationObserver(note).observe(document.documentElement, all);
    setInterval(note, 20);
  });
}

/** Polls /state.json until it is ended. */
export class StateLog {
  constructor(address) {
    this.entries = [];
    this.on = true;
    this.ended = this.poll(address);
  }

  async poll(address) {
    while (this.on) {
      const said = await state(address);
      this.entries.push({at_ms: Date.now(), worst: said?.troubles[0] ?? null, all: said?.troubles ?? [], said});
      await pause(50);
    }
  }

  end() {
    this.on = false;
    return this.ended;
  }
}

import {html, type TemplateResult} from 'lit';
import type {StopDevice, StopWord} from '../protocol.js';
import type {StopFate} from '../connection.js';
import {connection, store} from '../session.js';
import {StoreElement} from './store_element.js';

const kSymbols: Record<StopWord, string> = {idle: '○', requested: '…', acknowledged: '✓', silent: '✖'};

const kFates: Record<StopFate, string> = {waiting: 'not sent yet', sent: 'sent, no answer yet', failed: 'NO ANSWER'};

/** Stop, and what each device answered. */
export class StopPanel extends StoreElement {
  constructor() {
    super();
    this.pace_ms = 0;
    this.shows = ['choice', 'state'];
  }

  protected override render(): TemplateResult {
    const now = this.state();
    if (connection.stopFate === 'failed') return this.renderFailed();
    return html`
      <ul class="stop-devices" aria-label="Stop devices">
        ${this.devices().map((device) => this.renderDevice(device))}
      </ul>
      ${this.renderButton(now)}
    `;
  }

  private renderFailed(): TemplateResult {
    return html`
      <p class="stop-failed" role="alert">Stop had no answer: scripts/task stop, or its power switch</p>
      ${this.renderButton('idle')}
    `;
  }

  private renderButton(now: StopWord): TemplateResult {
    return html`<button class="stop" data-stop=${now} @click=${this.stop} aria-keyshortcuts="Escape S">
      <span class="stop-word">STOP</span><span class="stop-key">${this.words(now)}</span>
    </button>`;
  }

  private state(): StopWord {
    const said = store.life === 'open' ? (store.moment_live.part('stop')?.state ?? 'idle') : 'idle';
    return connection.stopFate === 'waiting' || connection.stopFate === 'sent' ? 'requested' : said;
  }

  private devices(): StopDevice[] {
    const told = store.life === 'open' ? (store.moment_live.part('stop')?.devices ?? []) : [];
    if (told.length > 0) return told;
    return (store.hello?.stop_devices ?? []).map((device) => ({device, state: 'idle', latched: null, reason: ''}));
  }

  private words(state: StopWord): string {
    if (connection.stopFate !== null) return kFates[connection.stopFate];
    return state === 'idle' ? 'Esc or S' : state;
  }

  private renderDevice(device: StopDevice): TemplateResult {
    const word =
      device.state === 'idle'
        ? device.latched
          ? 'latched'
          : device.latched === false
            ? 'free'
            : 'unknown'
        : device.state;
    return html`<li data-device=${device.device} data-stop=${device.state} title=${device.reason}>
      <span aria-hidden="true">${device.state === 'idle' && device.latched ? '■' : kSymbols[device.state]}</span>
      ${device.device} <b>${word}</b>
    </li>`;
  }

  private readonly stop = (): void => {
    connection.stop('stopped by hand on the page');
    store.tell('choice');
  };
}
customElements.define('mmi-stop', StopPanel);

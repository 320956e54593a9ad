import {html, type TemplateResult} from 'lit';
import {readAddress, writeAddress} from '../address.js';
import {icon, type IconName} from '../drawing/icons.js';
import {keyOf, typesText} from '../keys.js';
import {microseconds} from '../format.js';
import {pastWords} from '../past_words.js';
import {connection, store} from '../session.js';
import {StoreElement} from './store_element.js';
import './status_line.js';
import './stop_panel.js';
import './time_bar.js';
import {goToAddressed, goToEvent, playOrPause, showNewest, step} from '../transport.js';
import '../views/grasp_view.js';
import '../views/drive_view.js';
import '../views/health_view.js';
import '../views/log_view.js';

const kViews: {id: string; name: string; icon: IconName}[] = [
  {id: 'grasp', name: 'Grasp', icon: 'grasp'},
  {id: 'drive', name: 'Drive', icon: 'drive'},
  {id: 'health', name: 'Health', icon: 'health'},
  {id: 'log', name: 'Log', icon: 'log'},
];

const kThemes = ['auto', 'light', 'dark'] as const;

export class App extends StoreElement {
  private view = 'grasp';
  private theme: (typeof kThemes)[number] = 'auto';
  private address_at: string | null = null;
  private token: string | null = null;
  private written: string | null = null;

  constructor() {
    super();
    this.shows = ['choice', 'state'];
    this.pace_ms = 400;
    const address = readAddress(location.hash);
    this.view = kViews.some((view) => view.id === address.view) ? address.view : 'grasp';
    store.selected = address.selected;
    this.address_at = address.at;
    this.token = address.token;
    const theme = localStorage.getItem('theme');
    if (theme === 'light' || theme === 'dark') this.theme = theme;
    document.documentElement.dataset['theme'] = this.theme;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener('keydown', this.onKey, true);
    window.addEventListener('hashchange', this.onAddress);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener('keydown', this.onKey, true);
    window.removeEventListener('hashchange', this.onAddress);
  }

  protected override render(): TemplateResult {
    const log = store.hello?.log;
    const troubles = store.moment.part('troubles')?.length ?? 0;
    const past = pastWords(store);
    return html`
      ${
        store.is_log
          ? html`<div class="log-band">
              <span>LOG ${log?.path ?? store.hello?.bus}</span>
              <span>${log?.damaged ? '▲ damaged' : ''} ${log?.note ?? ''}</span>
            </div>`
          : ''
      }
      <h1 class="visually-hidden">The robot ${store.hello?.robot ?? ''}</h1>
      <header>
        <mmi-status></mmi-status>
        ${store.is_log ? '' : html`<mmi-stop></mmi-stop>`}
      </header>
      <div class="body">
        <nav aria-label="Views">
          <div role="tablist" aria-orientation="vertical" aria-label="Views" @keydown=${this.onTabKey}>
            ${kViews.map(
              (view, index) =>
                html`<button
                  role="tab"
                  id="tab-${view.id}"
                  aria-controls="view"
                  aria-selected=${view.id === this.view}
                  tabindex=${view.id === this.view ? 0 : -1}
                  title="${view.name} (key ${index + 1})"
                  @click=${() => this.show(view.id)}
                >
                  ${icon(view.icon)}${view.name}${view.id === 'health' && troubles > 0 ? html`<span class="count">▲ ${troubles}</span>` : ''}
                </button>`,
            )}
          </div>
          <button class="theme" @click=${this.nextTheme} title="Light, dark or as the system (key T)">
            ${icon('theme')}${this.theme === 'auto' ? 'Auto' : this.theme}
          </button>
        </nav>
        <main>
          ${past === null ? '' : html`<p class="past-label" role="status">${past}</p>`}
          <div id="view" role="tabpanel" aria-labelledby="tab-${this.view}">${this.renderView()}</div>
        </main>
      </div>
      <footer><mmi-time></mmi-time></footer>
    `;
  }

  protected override updated(): void {
    const lost = store.life !== 'open';
    document.body.dataset['connection'] = lost ? 'lost' : store.is_log ? 'log' : 'live';
    document.body.dataset['past'] = store.paused_at === null ? 'no' : 'yes';
    const hello = store.hello;
    document.title = hello ? `${store.is_log ? 'LOG ' : ''}${hello.robot || 'markservo'}` : 'markservo';
    if (hello && this.address_at !== null) {
      const at = this.address_at;
      this.address_at = null;
      goToAddressed(microseconds(at));
    }
    this.writeAddress();
  }

  private renderView(): TemplateResult {
    switch (this.view) {
      case 'drive':
        return html`<mmi-drive-view data-view="drive"></mmi-drive-view>`;
      case 'health':
        return html`<mmi-health-view data-view="health"></mmi-health-view>`;
      case 'log':
        return html`<mmi-log-view data-view="log"></mmi-log-view>`;
      default:
        return html`<mmi-grasp-view data-view="grasp"></mmi-grasp-view>`;
    }
  }

  private show(view: string): void {
    this.view = view;
    this.requestUpdate();
  }

  private writeAddress(): void {
    if (this.written !== null && location.hash !== this.written) {
      // Someone has just changed the address, and the browser has not told yet.
      this.onAddress();
      return;
    }
    const paused = store.is_log ? (store.play && !store.play.playing ? store.play.utime : null) : store.paused_at;
    const hash = writeAddress({
      view: this.view,
      selected: store.selected,
      at: this.address_at ?? (paused === null ? null : String(paused)),
      token: this.token,
    });
    if (hash !== location.hash) history.replaceState(null, '', hash);
    this.written = location.hash;
  }

  private readonly onAddress = (): void => {
    this.written = location.hash;
    const address = readAddress(location.hash);
    if (kViews.some((view) => view.id === address.view)) this.view = address.view;
    store.selected = address.selected;
    // An address without a token leaves us the one that we have.
    if (address.token !== null) {
      this.token = address.token;
      connection.useToken(address.token);
    }
    if (address.at !== null && store.hello) goToAddressed(microseconds(address.at));
    else if (address.at !== null) this.address_at = address.at;
    store.tell('choice');
  };

  private readonly nextTheme = (): void => {
    this.theme = kThemes[(kThemes.indexOf(this.theme) + 1) % kThemes.length]!;
    localStorage.setItem('theme', this.theme);
    document.documentElement.dataset['theme'] = this.theme;
    store.tell('choice');
  };

  private onTabKey(event: KeyboardEvent): void {
    const by = {ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1}[event.key];
    if (by === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const index = kViews.findIndex((view) => view.id === this.view);
    this.show(kViews[(index + by + kViews.length) % kViews.length]!.id);
    void this.updateComplete.then(() => this.querySelector<HTMLElement>('[role=tab][aria-selected=true]')?.focus());
  }

  private readonly onKey = (event: KeyboardEvent): void => {
    const key = keyOf(event, typesText(event.target));
    if (key === null) return;
    if (key === 'stop') {
      if (store.is_log) return;
      connection.stop('stopped by hand on the page');
      store.tell('choice');
    } else if (key === 'play') playOrPause();
    else if (key === 'next_frame') step(1);
    else if (key === 'previous_frame') step(-1);
    else if (key === 'next_event') goToEvent(1);
    else if (key === 'previous_event') goToEvent(-1);
    else if (key === 'newest') showNewest();
    else if (key === 'theme') this.nextTheme();
    else this.show(kViews[Number(key.slice(-1)) - 1]!.id);
    event.preventDefault();
  };
}
customElements.define('mmi-app', App);

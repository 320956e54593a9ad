/** What the address's fragment says: view, choice and time; and the token, which must not reach any server's log. */
export interface Address {
  view: string;
  selected: string | null;
  at: string | null;
  token: string | null;
}

export function readAddress(hash: string): Address {
  const parameters = new URLSearchParams(hash.replace(/^#/, ''));
  const at = parameters.get('at');
  return {
    view: parameters.get('view') ?? '',
    selected: parameters.get('select'),
    at: at !== null && /^\d{1,18}$/.test(at) ? at : null,
    token: parameters.get('token'),
  };
}

export function writeAddress(address: Address): string {
  const parameters = new URLSearchParams();
  if (address.view) parameters.set('view', address.view);
  if (address.selected) parameters.set('select', address.selected);
  if (address.at) parameters.set('at', address.at);
  if (address.token) parameters.set('token', address.token);
  return `#${parameters.toString()}`;
}

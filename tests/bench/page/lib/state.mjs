/** /state.json of mmi at `address`; null where nobody answers. */
export async function state(address) {
  try {
    const answer = await fetch(`${address}/state.json`, {signal: AbortSignal.timeout(1000)});
    return await answer.json();
  } catch {
    return null;
  }
}

/** ms. */
export function pause(ms) {
  return new Promise((resolve) => setTimeout(resolve, ms));
}

/** What `ask` gives once it is neither false, null nor undefined; null after `patience_s`. */
export async function until(ask, patience_s, every_ms = 50) {
  const end = Date.now() + 1000 * patience_s;
  while (true) {
    const answer = await ask();
    if (answer !== false && answer !== null && answer !== undefined) return answer;
    if (Date.now() > end) return null;
    await pause(every_ms);
  }
}

/** As `until`, but throws where it does not come. */
export async function must(what, ask, patience_s, every_ms = 50) {
  const answer = await until(ask, patience_s, every_ms);
  if (answer === null) throw new Error(`${what}: not within ${patience_s} s`);
  return answer;
}

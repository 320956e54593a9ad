// A person without a mouse: where the focus is, and how to get it to somewhere by Tab alone.

/** Tab presses after which a thing counts as out of reach: more than any view has of places to stop at. */
const kTabsAtMost = 400;

/** What has the focus: its words, and whether a person can see that it has it. */
function focused(page) {
  return page.evaluate(() => {
    const element = document.activeElement;
    const style = getComputedStyle(element);
    const words = (element.getAttribute('aria-label') ?? element.textContent ?? '').trim().replace(/\s+/g, ' ');
    return {
      words: `${element.tagName.toLowerCase()} ${words.slice(0, 60)}`,
      is_page: element === document.body,
      is_marked: style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 1,
    };
  });
}

/** Presses Tab until what has the focus matches `selector`. Throws where it does not come. */
export async function tabTo(page, selector) {
  for (let i = 0; i < kTabsAtMost; ++i) {
    if (await page.evaluate((wanted) => document.activeElement.matches(wanted), selector)) return;
    await page.keyboard.press('Tab');
  }
  throw new Error(`${selector}: not reached by ${kTabsAtMost} presses of Tab`);
}

/** Goes once round by Tab. What can be used and was not reached, and what shows no focus, in words. */
export async function tabRound(page) {
  await page.evaluate(() => {
    document.activeElement?.blur();
    window.reached = new Set();
    window.there = new Set(document.querySelectorAll('*'));
    window.noteFocus ??= document.addEventListener('focusin', (event) => window.reached.add(event.target)) ?? true;
  });
  const unmarked = new Set();
  for (let i = 0, rounds = 0; i < kTabsAtMost && rounds < 2; ++i) {
    await page.keyboard.press('Tab');
    const now = await focused(page);
    if (now.is_page) ++rounds;
    else if (!now.is_marked) unmarked.add(now.words);
  }
  // Of tabs and rows in a list one can be reached, and the arrows lead to the others. What has come since is left out.
  const missed = await page.evaluate(() => {
    const kinds = 'button, select, input, a[href], summary, [tabindex="0"]';
    const usable = [...document.querySelectorAll(kinds)].filter((element) => window.there.has(element)
      && element.tabIndex >= 0 && !element.disabled && element.checkVisibility({visibilityProperty: true}));
    const name = (element) => (element.getAttribute('aria-label') ?? element.textContent).trim().slice(0, 60);
    return usable.filter((element) => !window.reached.has(element)).map((element) =>
      `${element.tagName.toLowerCase()} ${name(element)}`);
  });
  return {reached: await page.evaluate(() => window.reached.size), missed, unmarked: [...unmarked]};
}

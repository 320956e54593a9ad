// What a screenshot shows.

/** Share of the way to white: less is the compositor's rounding. */
const kWhiterAtLeast = 0.05;

// Shows of all overlays nothing but what `selector` names; null: all as the page has it.
function showOnly(page, selector) {
  return page.evaluate((shown) => {
    const sheet = new CSSStyleSheet();
    if (shown !== null) sheet.replaceSync(`.overlay * {visibility: hidden !important} ${shown} {visibility: visible !important}`);
    document.adoptedStyleSheets = [sheet];
    return new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
  }, selector);
}

/** PNG files are decoded and compared in a page of their own. */
export class ScreenshotReader {
  static async open(browser) {
    const reader = new ScreenshotReader();
    reader.page = await browser.newPage();
    await reader.page.evaluate(() => {
      window.decode = async (base64) => {
        const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
        const bitmap = await createImageBitmap(new Blob([bytes], {type: 'image/png'}));
        const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
        context.drawImage(bitmap, 0, 0);
        return context.getImageData(0, 0, bitmap.width, bitmap.height);
      };
    });
    return reader;
  }

  /** Mean difference of two pictures of the same size, grey levels. */
  difference(png, other) {
    return this.page.evaluate(async ([a, b]) => {
      const [one, two] = [(await window.decode(a)).data, (await window.decode(b)).data];
      let sum = 0;
      for (let i = 0; i < one.length; ++i) sum += Math.abs(one[i] - two[i]);
      return sum / (0.75 * one.length); // without the alphas
    }, [png.toString('base64'), other.toString('base64')]);
  }

  // The middle of what is white in `png` and not in `without`, px of the screenshot, within `area`; null: nothing is.
  // By its edges: how much whiter a pixel gets depends on what is behind, where it ends does not.
  whiteIn(png, without, area) {
    return this.page.evaluate(async ([a, b, {x, y, width, height}, least]) => {
      const [with_it, without_it] = [await window.decode(a), await window.decode(b)];
      const columns = new Map();
      const rows = new Map();
      for (let j = Math.max(0, Math.floor(y)); j < Math.min(y + height, with_it.height); ++j) {
        for (let i = Math.max(0, Math.floor(x)); i < Math.min(x + width, with_it.width); ++i) {
          let [more, room] = [0, 0];
          for (let k = 0; k < 3; ++k) {
            const at = 4 * (j * with_it.width + i) + k;
            more += with_it.data[at] - without_it.data[at];
            room += 255 - without_it.data[at];
          }
          const share = room > 0 ? more / room : 0;
          if (share < least) continue;
          columns.set(i, Math.max(columns.get(i) ?? 0, share));
          rows.set(j, Math.max(rows.get(j) ?? 0, share));
        }
      }
      // A pixel at an end is filled by a share of the whitest one.
      const middleOf = (line) => {
        const places = [...line.keys()];
        const [first, last, most] = [Math.min(...places), Math.max(...places), Math.max(...line.values())];
        return (first + 1 - line.get(first) / most + last + line.get(last) / most) / 2;
      };
      return columns.size > 1 && rows.size > 1 ? [middleOf(columns), middleOf(rows)] : null;
    }, [png.toString('base64'), without.toString('base64'), area, kWhiterAtLeast]);
  }

  /** Where the marks' crosses stand in both images by the screenshot's white pixels, px of the image: [{side, name, cross}]. */
  async crosses(page, names) {
    const stages = await page.evaluate(() => [...document.querySelectorAll('.image-frame')].map((frame) => {
      const canvas = frame.querySelector('canvas');
      const box = canvas.getBoundingClientRect();
      // The browser draws pictures from whole pixel to whole pixel.
      const [x, y] = [Math.round(box.left), Math.round(box.top)];
      const [width, height] = [Math.round(box.right) - x, Math.round(box.bottom) - y];
      return {side: frame.dataset.side, x, y, width, height, columns: canvas.width, rows: canvas.height};
    }));
    const [left, top] = [Math.min(...stages.map(({x}) => x)), Math.min(...stages.map(({y}) => y))];
    const right = Math.max(...stages.map(({x, width}) => x + width));
    const bottom = Math.max(...stages.map(({y, height}) => y + height));
    const shoot = () => page.screenshot({clip: {x: left, y: top, width: right - left, height: bottom - top}});
    await showOnly(page, '.nothing');
    const without = await shoot();
    const found = [];
    for (const name of names) {
      await showOnly(page, `.overlay [data-mark="${name}"] .cross`);
      const png = await shoot();
      for (const stage of stages) {
        const middle = await this.whiteIn(png, without, {...stage, x: stage.x - left, y: stage.y - top});
        if (middle === null) continue;
        found.push({side: stage.side, name, cross: [((middle[0] + left - stage.x) / stage.width) * stage.columns - 0.5,
          ((middle[1] + top - stage.y) / stage.height) * stage.rows - 0.5]});
      }
    }
    await showOnly(page, null);
    return found;
  }
}

/** Screenshots of the first elements that match: PNG files as text. */
export async function shots(page, selectors) {
  const found = [];
  for (const selector of selectors) {
    const png = await page.locator(selector).first().screenshot({animations: 'disabled'});
    found.push(png.toString('base64'));
  }
  return found;
}

/** The left picture as its canvas holds it: a PNG file's bytes. */
export async function canvasPicture(page) {
  const url = await page.evaluate(() => document.querySelector('.image-frame[data-side=left] canvas').toDataURL('image/png'));
  return Buffer.from(url.slice(url.indexOf(',') + 1), 'base64');
}

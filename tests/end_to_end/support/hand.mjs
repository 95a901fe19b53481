// Steers the console by keyboard as a person does: reads what the step asks for, holds the arrow
// keys, slows down near the mark, and keeps still at it.
const coarseUntil_mm = 14;  // what a hold of the key runs on while the page is read again
const coarseUntil_deg = 60;

/** What a screen reader could tell of the task: the step's words, its value, and whether it is over. */
export function readTask(page) {
  return page.evaluate(() => {
    const at = (id) => document.querySelector(`[data-testid="${id}"]`);
    const value = at('step-value');
    return {
      title: at('step-title')?.textContent ?? '',
      ask: at('step-state')?.getAttribute('data-state') ?? '',
      value: value ? Number(value.getAttribute('data-value')) : null,
      overlay: at('overlay')?.getAttribute('data-kind') ?? '',
      verdict: document.querySelector('[aria-label="Verdict"] h1')?.textContent ?? '',
    };
  });
}

const goesOnByEnter = new Set(['restored', 'paused']);

const arrows = {feed: 'ArrowUp', retract: 'ArrowDown', clockwise: 'ArrowRight', 'counter-clockwise': 'ArrowLeft'};

// "Feed to 350 mm" -> 350
function targetOf(title) {
  const found = /([-\u2212]?\d+(?:\.\d+)?)\s*(mm|°|deg)/u.exec(title);
  return found ? {value: Number(found[1].replace('\u2212', '-')), unit: found[2]} : null;
}

function keysFor(task) {
  const arrow = arrows[task.ask];
  if (!arrow || task.value === null || task.overlay !== '') return [];
  const target = targetOf(task.title);
  const left = target ? Math.abs(target.value - task.value) : 0;
  const fine = left < (target?.unit === 'mm' ? coarseUntil_mm : coarseUntil_deg);
  return fine ? ['Shift', arrow] : [arrow];
}

/** Holds exactly these keys from now on. */
async function hold(page, held, wanted) {
  for (const key of [...held].filter((one) => !wanted.includes(one))) {
    await page.keyboard.up(key);
    held.delete(key);
  }
  for (const key of wanted.filter((one) => !held.has(one))) {
    await page.keyboard.down(key);
    held.add(key);
  }
}

/** Works through the steps until `done` says so of what is read; lets go of the keys in any case. */
export async function steerUntil(page, done, limit_ms) {
  const held = new Set();
  const end = Date.now() + limit_ms;
  try {
    for (;;) {
      const task = await readTask(page);
      if (done(task)) return task;
      if (Date.now() > end) throw new Error(`not done after ${limit_ms} ms: ${JSON.stringify(task)}`);
      await hold(page, held, keysFor(task));
      // a machine under load may lose the line for a moment: a person presses Enter and goes on
      if (goesOnByEnter.has(task.overlay)) await page.keyboard.press('Enter');
      await page.waitForTimeout(15);
    }
  } finally {
    await hold(page, held, []);
  }
}

/** Presses Enter at whatever notice waits for it until none lies over the picture. */
export async function goOn(page, limit_ms = 120_000) {
  const end = Date.now() + limit_ms;
  for (;;) {
    const {overlay} = await readTask(page);
    if (overlay === '') return;
    if (Date.now() > end) throw new Error(`the notice "${overlay}" did not go away`);
    if (overlay === 'start' || goesOnByEnter.has(overlay)) await page.keyboard.press('Enter');
    await page.waitForTimeout(250);
  }
}

// Renews the lease of the page that has armed the arm. A worker's timer keeps its pace in a tab in
// the background, where the page's own is slowed to one beat per second or per minute.

export {}; // a module: its names are its own

const kRenew_ms = 200;
const kPatience_ms = 500; // half of what the arm waits for before it holds
const page = self as unknown as Worker;

let timer: ReturnType<typeof setInterval> | undefined;
let renewal: AbortController | undefined; // one at a time: VENT needs a connection too

async function renew(lease: string): Promise<boolean> {
  const own = (renewal = new AbortController());
  const patience = setTimeout(() => own.abort(), kPatience_ms);
  const headers = { 'Content-Type': 'application/json' };
  try {
    const { ok } = await fetch('/api/arm/lease', {
      method: 'POST', headers, body: JSON.stringify({ lease }), signal: own.signal,
    });
    return ok;
  } catch {
    return true; // The next beat may get through; the server holds the arm meanwhile.
  } finally {
    clearTimeout(patience);
    if (renewal === own) renewal = undefined;
  }
}

/** A lease to renew; an empty one: none any more. */
page.onmessage = ({ data: lease }: MessageEvent<string>) => {
  clearInterval(timer);
  renewal?.abort();
  renewal = timer = undefined;
  if (lease === '') return;
  const own = (timer = setInterval(async () => {
    if (renewal || (await renew(lease)) || timer !== own) return;
    clearInterval(own);
    page.postMessage('over');
  }, kRenew_ms));
};
page.postMessage('ready');

// Renews the lease of the page that has armed the arm. A worker's timer keeps its pace in a tab in
// the background, where the page's own is slowed to one beat per second or per minute.

const kRenew_ms = 200;
const page = self as unknown as Worker;

let timer: ReturnType<typeof setInterval> | undefined;

/** A lease to renew; an empty one: none any more. */
page.onmessage = ({ data: lease }: MessageEvent<string>) => {
  clearInterval(timer);
  if (lease === '') return;
  const headers = { 'Content-Type': 'application/json' };
  const own = (timer = setInterval(async () => {
    try {
      const answer = await fetch('/api/arm/lease', { method: 'POST', headers, body: JSON.stringify({ lease }) });
      if (answer.ok) return;
      clearInterval(own);
      page.postMessage('over');
    } catch {
      // The next beat may get through; the server holds the arm meanwhile.
    }
  }, kRenew_ms));
};
page.postMessage('ready');

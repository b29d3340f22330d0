// One piece of work at a time, always for the newest request: those in between are never done, so
// a fast drag leaves no queue behind.

export function newest(work) {
  let waiting = null;
  let running = null;
  const run = async () => {
    try {
      while (waiting) {
        const request = waiting;
        waiting = null;
        await work(...request);
      }
    } finally {
      running = null;
    }
  };
  /** Resolves when nothing is left to do. */
  const ask = (...request) => {
    waiting = request;
    running ??= run();
    return running;
  };
  ask.idle = () => running ?? Promise.resolve();
  return ask;
}

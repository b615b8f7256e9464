// Runs the second module of the program beside the page: what the page asks for waits until the module is there, and is then done a
// piece at a time, so that what comes meanwhile is heard. A classic script: some browsers have no modules in workers.
// `cargo xtask dist` fills in what the module is called.

const SCRIPT = '';
const MODULE = '';

const asked = [];
let worker;
let isWorking = false;

/** Tells the page what cannot be done; it starts another worker the next time. */
function fail(error) {
  postMessage([JSON.stringify({ failed: String(error?.message ?? error) })]);
}

/** Lets what has come meanwhile be heard. */
const turn = new MessageChannel();
turn.port1.onmessage = () => work();

function tell() {
  for (let header = worker.report(); header !== undefined; header = worker.report()) postMessage([header]);
}

function work() {
  try {
    for (const [header, ...attachments] of asked.splice(0)) worker.receive(header, attachments);
    isWorking = worker.step();
    tell();
  } catch (error) {
    fail(error);
    return;
  }
  if (isWorking) turn.port2.postMessage(null);
}

onmessage = ({ data }) => {
  asked.push(data);
  if (worker && !isWorking) work();
};

async function start() {
  importScripts(SCRIPT);
  await wasm_bindgen({ module_or_path: new URL(MODULE, location.href) });
  worker = new wasm_bindgen.Worker();
  tell();
  if (asked.length) work();
}

start().catch(fail);

// The program once more, in a worker: the page sends it compiled, and says what it is to do.
import { giveFonts, initSync, serve } from "./lole_web.js";

const bytes = async (address) => new Uint8Array(await (await fetch(address)).arrayBuffer());

self.onmessage = async (first) => {
  // What comes before it listens is kept.
  const waiting = [];
  self.onmessage = (event) => waiting.push(event);
  const { module, role } = first.data;
  initSync({ module });
  if (role === "maker" || role === "order") {
    giveFonts(...await Promise.all([bytes("paper-regular.otf"), bytes("paper-bold.otf")]));
  }
  serve(role);
  for (const event of waiting) self.onmessage(event);
};

// Fetches the program, its letters and what was kept from the last visit, and opens the studio.
import init, { Page, scene, scenes } from "./lole_web.js";

const say = (text) => { document.getElementById("say").textContent = text; };
const inJapanese = (navigator.language || "ja").startsWith("ja");
const asked = new URLSearchParams(location.search);

// Files that designs name, kept by the browser from one visit to the next.
const shelf = () => new Promise((resolve, reject) => {
  const request = indexedDB.open("lole", 1);
  request.onupgradeneeded = () => request.result.createObjectStore("files");
  request.onsuccess = () => resolve(request.result);
  request.onerror = () => reject(request.error);
});

globalThis.loleKeepFile = (name, bytes) => {
  const copy = bytes.slice();
  shelf().then((database) => {
    database.transaction("files", "readwrite").objectStore("files").put(copy, name);
  }).catch(() => {});
};

const kept = async () => {
  try {
    const database = await shelf();
    return await new Promise((resolve) => {
      const files = [];
      const cursor = database.transaction("files").objectStore("files").openCursor();
      cursor.onsuccess = () => {
        const found = cursor.result;
        if (!found) { resolve(files); return; }
        files.push([found.key, found.value]);
        found.continue();
      };
      cursor.onerror = () => resolve(files);
    });
  } catch { return []; }
};

const face = async (address) => {
  const answer = await fetch(address);
  return answer.ok ? new Uint8Array(await answer.arrayBuffer()) : null;
};

// For those who check this page: `?scenes` runs the engine's scenes and shows what they come to.
const check = async () => {
  await init();
  const rows = [];
  for (const name of scenes().split("\n")) {
    rows.push(scene(name));
    say(rows[rows.length - 1]);
    await new Promise((resolve) => setTimeout(resolve));
  }
  const list = document.createElement("pre");
  list.id = "scenes";
  list.textContent = rows.join("\n");
  document.getElementById("wait").replaceChildren(list);
};

const open = async () => {
  const [files, letters] = await Promise.all([kept(), face("letters.otf"), init()]);
  const page = new Page(document.getElementById("studio"), navigator.language);
  if (letters) page.face(letters);
  for (const [name, bytes] of files) page.file(name, bytes);
  await page.open();
  document.getElementById("wait").hidden = true;
  document.documentElement.dataset.lole = performance.now().toFixed(0);
};

// A browser takes graphics away when its driver fails or a laptop wakes up. The work is kept as it changes, so that
// the page opens again; where that does not help, it is said.
const LOST = "lole.lost";
document.getElementById("studio").addEventListener("webglcontextlost", () => {
  const last = Number(sessionStorage.getItem(LOST));
  sessionStorage.setItem(LOST, String(Date.now()));
  if (60000 < Date.now() - last) location.reload();
  else {
    document.getElementById("wait").hidden = false;
    failed(inJapanese ? "グラフィックスが止まりました" : "the graphics stopped");
  }
});

const failed = (error) => {
  console.error(error);
  document.documentElement.dataset.failed = error;
  say(inJapanese
    ? `開けませんでした。読み直すか、ほかのブラウザーでお試しください。（${error}）`
    : `It could not be opened; reload the page, or try another browser. (${error})`);
};

// Says that another build was fetched. Whoever does not press it goes on with the one that is open, and finds the
// other next time; the design is kept either way.
const offer = (waiting) => {
  const bar = document.createElement("button");
  bar.id = "update";
  bar.className = "bar";
  bar.textContent = inJapanese
    ? "新しい版があります。押すと開き直します（デザインはそのまま残ります）"
    : "A new version is here. Press to reopen; your design stays as it is";
  bar.onclick = () => waiting.postMessage("now");
  document.body.append(bar);
};

const keepOffline = async () => {
  const isFirst = !navigator.serviceWorker.controller;
  const registration = await navigator.serviceWorker.register("offline.js");
  if (registration.waiting && !isFirst) offer(registration.waiting);
  registration.onupdatefound = () => {
    const next = registration.installing;
    next.onstatechange = () => {
      if (next.state === "installed" && !isFirst) offer(next);
    };
  };
  navigator.serviceWorker.oncontrollerchange = () => { if (!isFirst) location.reload(); };
  // The dance comes first; what only visits without a network need can wait.
  const ready = await navigator.serviceWorker.ready;
  setTimeout(() => ready.active.postMessage("later"), 20000);
};

// Asks the browser not to clear the design when it needs room. Where it does not agree, that is said once.
const keepDesign = async () => {
  if (await navigator.storage?.persist?.() || localStorage.getItem("lole.warned")) return;
  const warn = () => {
    if (!localStorage.getItem("lole.work")) { setTimeout(warn, 60000); return; }
    const bar = document.createElement("button");
    bar.id = "purge";
    bar.className = "bar";
    bar.textContent = inJapanese
      ? "このブラウザーは、しばらく開かないとデザインを消すことがあります。「保存」でファイルにも残してください（押すと閉じます）"
      : "This browser may clear the design when the page was not opened for a while. Press “Save” to keep a file, too. (Press to close)";
    bar.onclick = () => { localStorage.setItem("lole.warned", "1"); bar.remove(); };
    document.body.append(bar);
  };
  setTimeout(warn, 60000);
};

(asked.has("scenes") ? check() : open()).catch(failed);

if (!asked.has("scenes")) {
  if ("serviceWorker" in navigator) keepOffline().catch(() => {});
  keepDesign().catch(() => {});
}

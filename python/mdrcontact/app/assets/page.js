// SPDX-License-Identifier: GPL-3.0-or-later
const say = words => {
  const alert = document.querySelector("section:not([hidden]) [role=alert]");
  if (alert) dash_clientside.set_props(alert.id, { children: words });
};

// Dash shows nothing if the server does not answer, or is another one.
const ask = window.fetch;
window.fetch = async (...request) => {
  let answer;
  try {
    return answer = await ask(...request);
  } finally {
    if (!answer || answer.status === 403) say("mdrcontact app no longer answers. Start it again and open the address that it prints.");
  }
};

// The server does not read larger drops, and dcc.Upload reports no rejected files.
const MOST = 290e6;

for (const kind of ["change", "drop"]) {
  document.addEventListener(kind, event => {
    const place = event.target.closest("[id$='-drop'], [id$='-open']");
    const files = [...((event.dataTransfer ?? event.target).files ?? [])];
    if (place && files.reduce((sum, file) => sum + file.size, 0) > MOST) {
      event.preventDefault();
      event.stopPropagation();
      if (kind === "change") event.target.value = "";
      say(`files: together they have more than ${MOST / 1e6} MB. Drop fewer or smaller files.`);
    }
  }, true);
}

// Esc removes the message. Ctrl+Z undoes the last change of the form, unless a field contains text that is not entered yet.
let typed = null;
document.addEventListener("input", event => { typed = event.target; }, true);
document.addEventListener("change", () => { typed = null; }, true);
document.addEventListener("keydown", event => {
  if (event.key === "Escape") say("");
  if ((event.ctrlKey || event.metaKey) && !event.shiftKey && event.key === "z" && event.target !== typed) {
    event.preventDefault();
    document.getElementById("undo").click();
  }
});

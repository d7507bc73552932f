// SPDX-License-Identifier: GPL-3.0-or-later
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
      const words = `files: together they have more than ${MOST / 1e6} MB. Drop fewer or smaller files.`;
      dash_clientside.set_props(place.id.replace(/-.*/, "-alert"), { children: words });
    }
  }, true);
}

// Esc removes the message. Ctrl+Z undoes the last change of the form, unless a field contains text that is not entered yet.
let typed = null;
document.addEventListener("input", event => { typed = event.target; }, true);
document.addEventListener("change", () => { typed = null; }, true);
document.addEventListener("keydown", event => {
  const alert = document.querySelector("section:not([hidden]) [role=alert]");
  if (event.key === "Escape" && alert) dash_clientside.set_props(alert.id, { children: "" });
  if ((event.ctrlKey || event.metaKey) && !event.shiftKey && event.key === "z" && event.target !== typed) {
    event.preventDefault();
    document.getElementById("undo").click();
  }
});

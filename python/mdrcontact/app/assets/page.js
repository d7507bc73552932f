// SPDX-License-Identifier: GPL-3.0-or-later
// The server does not read larger drops, and the page would show nothing.
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

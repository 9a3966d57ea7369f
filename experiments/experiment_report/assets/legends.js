"use strict";
// A click on a name of a figure's legend hides the marks of its series, another one shows them again.
for (const button of document.querySelectorAll(".legend button")) {
  button.addEventListener("click", () => {
    const shown = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(shown));
    for (const mark of button.closest("figure").querySelectorAll(`.mark.${button.dataset.series}`)) {
      mark.toggleAttribute("hidden", !shown);
    }
  });
}

// In place of the theme's script of this name, which Debian ships as a module that no page can load: light
// or dark as the reader's system has it, until the button in the corner says otherwise.
(() => {
  const kKey = "theme", kDark = "dark", kLight = "light";
  const system = window.matchMedia("(prefers-color-scheme: dark)");

  function show() {
    const chosen = localStorage.getItem(kKey);
    const known = chosen === kDark || chosen === kLight;
    document.body.dataset.theme = known ? chosen : system.matches ? kDark : kLight;
  }

  function turn() {
    localStorage.setItem(kKey, document.body.dataset.theme === kDark ? kLight : kDark);
    show();
  }

  system.addEventListener("change", show);
  for (const button of document.getElementsByClassName("theme-toggle")) {
    button.addEventListener("click", turn);
  }
  document.documentElement.classList.remove("no-js");  // by which the theme hides its button
  show();
})();

// Light and dark: as the system says, until the reader chooses.
import { element } from "./element";

const dark = window.matchMedia("(prefers-color-scheme: dark)");

function tell(): void {
  window.dispatchEvent(new Event("themechange"));
}

export function themeButton(): HTMLElement {
  const root = document.documentElement;
  const isDark = (): boolean => (root.dataset.theme ?? (dark.matches ? "dark" : "light")) === "dark";
  const button = element("button", { type: "button", class: "theme" });
  const name = (): void => {
    button.textContent = isDark() ? "Light" : "Dark";
  };
  button.addEventListener("click", () => {
    root.dataset.theme = isDark() ? "light" : "dark";
    name();
    tell();
  });
  dark.addEventListener("change", () => {
    name();
    tell();
  });
  name();
  return button;
}

// On paper everything is unfolded, and the colours are those of paper.
export function openForPrint(): void {
  const closed = new Set<HTMLDetailsElement>();
  const root = document.documentElement;
  let theme: string | undefined;
  window.addEventListener("beforeprint", () => {
    theme = root.dataset.theme;
    root.dataset.theme = "light";
    tell();
    for (const one of document.querySelectorAll("details")) {
      if (one.open) continue;
      closed.add(one);
      one.open = true;
    }
  });
  window.addEventListener("afterprint", () => {
    if (theme === undefined) delete root.dataset.theme;
    else root.dataset.theme = theme;
    tell();
    for (const one of closed) one.open = false;
    closed.clear();
  });
}

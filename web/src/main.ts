// Makes the page from the data that the program has written into it.
import "./page.css";
import { pageNodes } from "./answer/page";
import type { GalleryData, PageData } from "./document";
import { append } from "./element";
import { galleryNodes } from "./gallery/gallery";
import { setByBrowserWithoutFonts } from "./text/math";
import { openForPrint, themeButton } from "./theme";

function data(id: string): unknown {
  const text = document.getElementById(id)?.textContent;
  return text === undefined ? undefined : (JSON.parse(text) as unknown);
}

setByBrowserWithoutFonts();
const page = data("poinsot-page") as PageData | undefined;
const gallery = data("poinsot-gallery") as GalleryData | undefined;
append(document.body, page ? pageNodes(page) : gallery ? galleryNodes(gallery) : []);
document.querySelector("header")?.append(themeButton());
openForPrint();

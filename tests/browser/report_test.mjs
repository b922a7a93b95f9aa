// Opens a report in a browser as a stranger would: desktop, phone, dark, printed, without scripts.
//   node report_test.mjs REPORT SCREENSHOTS
// Exit code 0: all claims hold. Screenshots are left for people to look at.

import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [report, screenshots] = process.argv.slice(2);
const address = pathToFileURL(report).href;
const problems = [];
let claims = 0;

function expect(holds, claim) {
  ++claims;
  if (!holds) problems.push(claim);
}

// What a browser is told so that it does nothing on its own.
const flags = ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync"];
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: flags });

async function open(settings, name) {
  const context = await browser.newContext({ acceptDownloads: true, ...settings });
  const page = await context.newPage();
  page.on("console", (message) => expect(message.type() !== "error" && message.type() !== "warning",
    `${name}: console says ${message.text()}`));
  page.on("pageerror", (error) => expect(false, `${name}: ${error.message}`));
  page.on("dialog", (dialog) => { expect(false, `${name}: a dialog opened`); dialog.dismiss(); });
  page.on("request", (request) => expect(request.url() === address || /^(data|blob):/.test(request.url()),
    `${name}: a request leaves the file: ${request.url()}`));
  await page.goto(address);
  return page;
}

// Every figure holds pictures of some size with something drawn in them.
async function chartsAreDrawn(page, name) {
  const figures = await page.$$eval("figure", (all) => all.map((figure) => ({
    id: figure.id,
    pictures: [...figure.querySelectorAll("svg.plot")].map((svg) => {
      const box = svg.getBoundingClientRect();
      return { width: box.width, height: box.height, marks: svg.querySelectorAll("path,circle,rect,line").length };
    }) })));
  expect(figures.length > 5, `${name}: only ${figures.length} figures`);
  for (const { id, pictures } of figures) {
    expect(pictures.length > 0, `${name}: ${id} has no picture`);
    for (const { width, height, marks } of pictures)
      expect(width > 60 && height > 30 && marks > 3, `${name}: ${id} is ${width} x ${height} with ${marks} marks`);
  }
  return figures.length;
}

async function fitsTheScreen(page, name) {
  const excess = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
  expect(excess <= 0, `${name}: the page is ${excess} px too wide`);
}

async function everyChartZooms(page, name) {
  for (const figure of await page.$$("figure.xy")) {
    const id = await figure.evaluate((node) => node.id);
    const button = await figure.$("button.main");
    expect(button !== null, `${name}: ${id} cannot be zoomed`);
    if (!button) continue;
    await button.click();
    // Pixels that are not transparent: axes, grid and curves.
    const painted = await figure.$eval("canvas", (canvas) => {
      const data = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
      let count = 0;
      for (let k = 3; k < data.length; k += 4) count += data[k] > 0 ? 1 : 0;
      return count;
    });
    expect(painted > 500, `${name}: ${id} has ${painted} pixels when live`);
    await button.click();
    expect(await figure.$eval("svg.plot", (svg) => svg.getBoundingClientRect().height > 30), `${name}: ${id} does not come back`);
  }
}

async function zoomingNarrowsTheAxis(page) {
  const figure = await page.$("figure.xy");
  await (await figure.$("button.main")).click();
  const plot = await figure.$(".u-over");
  await plot.scrollIntoViewIfNeeded();
  const box = await plot.boundingBox();
  const image = () => figure.$eval("canvas", (canvas) => canvas.toDataURL());
  const before = await image();
  await page.mouse.move(box.x + box.width * 0.3, box.y + box.height * 0.3);
  const shown = await figure.$$eval(".u-legend .u-value", (cells) => cells.map((cell) => cell.textContent));
  expect(shown.some((text) => /\d/.test(text)), "hovering shows no number");
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.6, box.y + box.height * 0.7, { steps: 5 });
  await page.mouse.up();
  await page.waitForTimeout(100);
  expect((await image()) !== before, "dragging does not zoom");
  await (await figure.$("button.main")).click();
}

async function downloadsWork(page) {
  const wanted = [["figure.xy", "CSV", /^series,/], ["figure.xy", "SVG", /^<svg/], ["figure.packing", "SVG", /<circle/],
    ["figure.bars", "CSV", /^label,/], ["figure.xy", "PNG", /^.PNG/]];
  for (const [selector, label, content] of wanted) {
    const figure = await page.$(selector);
    if (!figure) continue;
    const [download] = await Promise.all([page.waitForEvent("download"), (await figure.$(`.tools >> text="${label}"`)).click()]);
    const text = readFileSync(await download.path(), "latin1");
    expect(download.suggestedFilename().endsWith("." + label.toLowerCase()), `${label}: the file is called ${download.suggestedFilename()}`);
    expect(content.test(text) && text.length > 200, `${label} of ${selector} holds ${text.slice(0, 40)}`);
    if (label === "CSV") expect(!/(^|[,\n"])[=@]/.test(text), `a CSV cell of ${selector} is a formula`);
  }
}

async function tablesSort(page) {
  const table = await page.$("table.sortable");
  const column = await table.$$eval("thead th", (cells) => cells.findIndex((cell) => cell.textContent.startsWith("sweeps")));
  const values = () => table.$$eval("tbody tr", (rows, at) => rows.map((row) => row.cells[at].dataset.v).filter((v) => v !== undefined).map(Number), column);
  for (const direction of [1, -1]) {
    await (await table.$$("thead button"))[column].click();
    const now = await values();
    expect(now.length > 1 && now.every((value, k) => k === 0 || direction * (value - now[k - 1]) >= 0), `sorting gives ${now}`);
  }
}

// --- A desktop, a phone, the dark, paper, and no scripts.
const desktop = await open({ viewport: { width: 1280, height: 900 } }, "desktop");
const count = await chartsAreDrawn(desktop, "desktop");
await fitsTheScreen(desktop, "desktop");
expect(await desktop.evaluate(() => window.hacked === undefined), "a name was run as a script");
expect(await desktop.$$eval("nav a", (links) => links.every((link) => document.getElementById(link.hash.slice(1)))), "a link leads nowhere");
await desktop.screenshot({ path: `${screenshots}/desktop.png`, fullPage: true });
await everyChartZooms(desktop, "desktop");
await zoomingNarrowsTheAxis(desktop);
await downloadsWork(desktop);
await tablesSort(desktop);

const phone = await open({ viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true, deviceScaleFactor: 2, colorScheme: "dark" }, "phone");
expect((await chartsAreDrawn(phone, "phone")) === count, "the phone has other charts");
await fitsTheScreen(phone, "phone");
await everyChartZooms(phone, "phone");
const smallest = await phone.$$eval("figure svg.plot text", (texts) => Math.min(...texts.map((text) => text.getBoundingClientRect().height)));
expect(smallest > 7, `text in charts is ${smallest} px high on a phone`);
const brightness = await phone.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number).reduce((a, b) => a + b) / 3);
expect(brightness < 60, `the dark page has a brightness of ${brightness}`);
await phone.screenshot({ path: `${screenshots}/phone.png`, fullPage: true });

const plain = await open({ viewport: { width: 1280, height: 900 }, javaScriptEnabled: false }, "no scripts");
expect((await plain.$$("figure svg.plot")).length >= count, "without scripts charts are missing");
expect((await plain.$$(".tools")).length === 0, "without scripts there are buttons that do nothing");

const paper = await open({ viewport: { width: 900, height: 1200 } }, "paper");
await (await paper.$("figure.xy button.main")).click();
await paper.emulateMedia({ media: "print" });
await chartsAreDrawn(paper, "paper");
expect(await paper.$eval(".tools", (tools) => getComputedStyle(tools).display === "none"), "buttons are printed");

await browser.close();
for (const problem of problems) console.error("FAILED: " + problem);
console.log(`${claims - problems.length} claims hold, ${problems.length} fail; ${count} charts`);
process.exit(problems.length === 0 ? 0 : 1);
